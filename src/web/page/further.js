// What can be asked beside the answer: the trade-off, a sample, a proof.

import { readingCommand } from "./answer.js";
import { byId, fill, make } from "./dom.js";
import { endInWords } from "./ends.js";
import { onChoice, onDrop, plainName } from "./files.js";
import { withPoint } from "./numbers.js";
import { DEFAULTS, KINDS_WITH_VALUE, conditionFlags } from "./question.js";
import { notesWith, readingView } from "./reading_view.js";
import { saidLines } from "./said.js";
import { showSample } from "./sample_view.js";
import { text } from "./texts.js";
import { showTradeoff } from "./tradeoff_view.js";
import { judge, showVerdict } from "./verdict.js";
import { checkers, helper, reader, rowsOf } from "./workers.js";

let state;
const shown = { tradeoff: null, sample: null, verdict: null, reading: null };
const chosen = { gradation: null, proof: null, sample: null };

/** What is said of a file of particles, which goes with it. */
const SAMPLE_CONTROLS = ["sample-unit", "sample-measure"];

const message = (words) => saidLines("pre", { class: "message" }, words.trim());

/** Shows that the helper works on something, with a button that ends it. */
function showWork(place, key) {
  const stop = make("button", { type: "button" }, text("stop"));
  stop.addEventListener("click", () => helper.stop());
  fill(place, make("p", { class: "searching", role: "status" }, make("span", { class: "pulse", "aria-hidden": "true" }),
    make("span", {}, text(key)), stop));
}

/** Runs the helper and shows its report, or its message. */
async function report({ place, key, argv, files, operation, show }) {
  const output = "mdm-report.json";
  showWork(place, key);
  try {
    const { err, files: written } = await helper.run([...argv, "--format", "json", "-o", output], files);
    const blob = written[output];
    if (blob) show(await reader.ask({ operation, blob }), blob);
    else fill(place, message(err));
  } catch (error) {
    fill(place, make("p", {}, endInWords(error)));
  }
}

function computeTradeoff() {
  if (state.solution === null) return;
  const { checked, reading } = state.solution;
  const { toleranceKind } = state.options;
  const kind = KINDS_WITH_VALUE.includes(toleranceKind) ? toleranceKind : "retained";
  report({
    place: byId("tradeoff-result"),
    key: "tradeoff.running",
    argv: ["tradeoff", checked.name, "--kind", kind, ...conditionFlags(state.options)],
    files: { [checked.name]: checked.blob },
    operation: "tradeoff",
    show: (found, file) => {
      shown.tradeoff = { ...found, file, notes: notesWith(found.notes, reading) };
      showTradeoff(shown.tradeoff, rowsOf("sieves"));
    },
  });
}

function takeSample(file) {
  if (chosen.sample !== null) for (const id of SAMPLE_CONTROLS) byId(id).value = "";
  chosen.sample = file;
  judgeSample();
}

function judgeSample() {
  const file = chosen.sample;
  if (state.solution === null || file === null) return;
  const { checked, reading } = state.solution;
  const sample = plainName(file.name);
  const name = sample === checked.name ? `sample-${sample}` : sample;
  const unit = byId("sample-unit").value;
  const measure = byId("sample-measure").value;
  const cut = state.options.cut;
  report({
    place: byId("sample-result"),
    key: "sample.running",
    argv: [
      "verify", checked.name, name,
      "--tolerance", `${withPoint(byId("sample-tolerance").value) || "0"}%`,
      ...(unit ? ["--size-unit", unit] : []),
      ...(measure ? [measure] : []),
      ...(cut ? ["--cut-below", cut] : []),
    ],
    files: { [checked.name]: checked.blob, [name]: file },
    operation: "verification",
    show: (found) => {
      shown.sample = { ...found, notes: notesWith(found.notes, reading) };
      showSample(shown.sample, rowsOf("sample"));
    },
  });
}

function writeNames() {
  byId("proof-gradation-name").textContent = chosen.gradation?.name ?? text("proof.none");
  byId("proof-proof-name").textContent = chosen.proof?.name ?? text("proof.none");
}

async function isProof(file) {
  return (await file.slice(0, 15).text()).startsWith("mdm-certificate");
}

async function takeDropped(files) {
  for (const file of files) chosen[(await isProof(file)) ? "proof" : "gradation"] = file;
  writeNames();
  if (chosen.gradation && chosen.proof) checkChosen();
}

/** What is read of the gradation whose proof is checked; null if it is none. */
async function readingOf(gradation) {
  const output = `${gradation.name}.reading.json`;
  const { files } = await helper.run(readingCommand(gradation.name, [], output), { [gradation.name]: gradation.blob });
  if (files[output] === undefined) return null;
  return { name: gradation.name, ...(await reader.ask({ operation: "reading", blob: files[output] })) };
}

function showChecked() {
  const { verdict, reading } = shown;
  const read = reading ? readingView(reading, DEFAULTS, reading.notes) : make("p", {}, text("read.nothing"));
  showVerdict(byId("proof-result"), verdict, read);
}

async function checkChosen() {
  const place = byId("proof-result");
  place.className = "";
  shown.verdict = null;
  if (!chosen.gradation || !chosen.proof) return fill(place, make("p", {}, text("proof.missing")));
  const gradation = { name: plainName(chosen.gradation.name), blob: chosen.gradation };
  const plain = plainName(chosen.proof.name);
  const proof = { name: plain === gradation.name ? `${plain}.proof` : plain, blob: chosen.proof };
  fill(place, make("p", {}, text("verdict.checking")));
  try {
    const reading = await readingOf(gradation);
    const verdict = await judge(checkers, gradation, proof);
    Object.assign(shown, { reading, verdict });
    showChecked();
  } catch (error) {
    fill(place, make("p", {}, endInWords(error)));
  }
}

/** Writes the texts of these parts again, in the language of the page. */
export function writeFurtherTexts() {
  writeNames();
  if (shown.tradeoff) showTradeoff(shown.tradeoff, rowsOf("sieves"));
  if (shown.sample) showSample(shown.sample, rowsOf("sample"));
  if (shown.verdict) showChecked();
}

/** Forgets what was found about another gradation. */
export function forgetFindings() {
  helper.stop();
  Object.assign(shown, { tradeoff: null, sample: null });
  chosen.sample = null;
  fill(byId("tradeoff-result"));
  fill(byId("sample-result"));
}

/** Makes these parts work on the page's state. */
export function startFurther(given) {
  state = given.state;
  byId("tradeoff-run").addEventListener("click", computeTradeoff);
  onChoice(byId("sample-file"), takeSample);
  onDrop(byId("sample-drop"), ([file]) => takeSample(file));
  for (const id of [...SAMPLE_CONTROLS, "sample-tolerance"]) byId(id).addEventListener("change", judgeSample);
  onChoice(byId("proof-gradation-file"), (file) => {
    chosen.gradation = file;
    writeNames();
  });
  onChoice(byId("proof-proof-file"), (file) => {
    chosen.proof = file;
    writeNames();
  });
  onDrop(byId("proof-drop"), takeDropped);
  byId("proof-check").addEventListener("click", checkChosen);
}
