// What can be taken from the page: files, the printed report, and a link to the question.

import { commandLine } from "./command_line.js";
import { readOptions } from "./controls.js";
import { curveFile } from "./curve.js";
import { byId, fill, make } from "./dom.js";
import { endInWords } from "./ends.js";
import { download, stem } from "./files.js";
import { currentGradation } from "./gradation_input.js";
import { fragmentOf } from "./link.js";
import { pngOf } from "./picture.js";
import { readingFlags, soilFlags, specimenFlags } from "./question.js";
import { readInWords } from "./reading_view.js";
import { writeReport } from "./report.js";
import { saidLines } from "./said.js";
import { text } from "./texts.js";
import { checkers, helper, reader } from "./workers.js";

/** The endings by which the engines know their models. */
const MODEL_NAMES = { liggghts: "liggghts.in", lammps: "lammps.in", yade: "yade.py" };

let page;

function note(...content) {
  fill(byId("download-note"), ...content);
}

async function saveGradation() {
  const { gradation } = page.state.solution;
  const name = `${stem(gradation.name)}.canonical.csv`;
  const argv = ["convert", gradation.name, ...readingFlags(page.state.options), "--format", "csv", "-o", name];
  const { files, err } = await helper.run(argv, { [gradation.name]: gradation.blob });
  if (files[name]) download(name, files[name]);
  else note(saidLines("pre", {}, err.trim()));
}

/** Offers the curve's picture as a file, made by `fileOf` from SVG; below it stands how the gradation was read. */
async function savePicture(ending, fileOf) {
  const { solution, options } = page.state;
  const limits = page.soil().description ? soilFlags(readOptions()) : [];
  const { blob, err } = await curveFile(solution, options, [...limits, "--caption", readInWords(solution.reading)]);
  if (blob) download(`${base()}.${ending}`, await fileOf(blob));
  else note(saidLines("pre", {}, err.trim()));
}

const base = () => stem(page.state.solution.gradation.name);

const downloads = {
  json: () => download(page.state.solution.answerFile.name, page.state.solution.answerFile.blob),
  csv: async () => download(`${base()}.answer.csv`, await reader.ask({ operation: "csv" })),
  proof: () => download(page.state.solution.proof.name, page.state.solution.proof.blob),
  gradation: saveGradation,
  svg: () => savePicture("svg", (svg) => svg),
  png: () => savePicture("png", pngOf),
};

/** Writes a model by mdm export and offers its files. */
async function writeModel(engine) {
  const { answerFile } = page.state.solution;
  const name = `${base()}-${MODEL_NAMES[engine]}`;
  const specimen = specimenFlags(page.state.options);
  const start = specimen[0] === "--specimen" ? specimen : [];
  const argv = ["export", answerFile.name, "--to", engine, "--model", "settle", ...start, "-o", name];
  note(make("p", {}, text("model.writing")));
  try {
    const { files, err } = await helper.run(argv, { [answerFile.name]: answerFile.blob });
    const buttons = Object.entries(files).map(([file, blob]) => {
      const button = make("button", { type: "button" }, file);
      button.addEventListener("click", () => download(file, blob));
      return button;
    });
    note(
      buttons.length > 0 ? make("h4", {}, text("model.files")) : null,
      buttons.length > 0 ? make("p", { class: "buttons" }, ...buttons) : null,
      err.trim() ? saidLines("pre", {}, err.trim()) : null,
    );
  } catch (error) {
    note(make("p", {}, endInWords(error)));
  }
}

async function digestOf({ name, blob }) {
  return { name, digest: await reader.ask({ operation: "digest", blob }) };
}

async function printReport() {
  const { solution, options, verdict } = page.state;
  const { description } = page.soil();
  const { gradation, checked, proof, flags } = solution;
  const files = [gradation, ...(checked === gradation ? [] : [checked]), ...(proof ? [proof] : [])];
  const digests = [];
  for (const file of files) digests.push(await digestOf(file));
  const { out: checkerVersion } = await checkers[0].program.run(["--version"], {});
  const command = commandLine({
    gradation: gradation.name,
    flags,
    proofName: proof ? proof.name : "proof",
    checkedName: checked.name,
  });
  await writeReport({
    solution, options, description, verdict, digests, command, checkerVersion,
    fetchRows: page.fetchRows,
    ...page.words(options),
  });
  window.print();
}

async function copyLink() {
  const { name, blob } = currentGradation();
  const bytes = new Uint8Array(await blob.arrayBuffer());
  const fragment = await fragmentOf({ name, options: page.options(), bytes });
  if (fragment === null) return note(make("p", {}, text("link.too-long")));
  const url = location.href.replace(/#.*$/, "") + "#" + fragment;
  history.replaceState(null, "", "#" + fragment);
  const field = make("input", { class: "link", readOnly: true, value: url, "aria-label": text("download.link") });
  let said = "link.copied";
  try {
    await navigator.clipboard.writeText(url);
  } catch {
    said = "link.here";
  }
  note(make("p", {}, text(said)), field);
  field.select();
}

/** Makes the buttons work; `given` has state, soil(), words(options), fetchRows and options(). */
export function startDownloads(given) {
  page = given;
  for (const button of document.querySelectorAll("[data-download]")) {
    button.addEventListener("click", () => downloads[button.dataset.download]());
  }
  for (const button of document.querySelectorAll("[data-model]")) {
    button.addEventListener("click", () => writeModel(button.dataset.model));
  }
  byId("print").addEventListener("click", printReport);
  byId("copy-link").addEventListener("click", copyLink);
  window.addEventListener("afterprint", () => fill(byId("report")));
}
