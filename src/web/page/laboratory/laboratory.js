// The Report section: samples come in, two analyses of one sample are joined, and mdm report writes the laboratory's report.

import { byId, fill, make } from "../dom.js";
import { endInWords } from "../ends.js";
import { download, freeName, onChoice, onDrop, stem } from "../files.js";
import { saidLines } from "../said.js";
import { offerSpecifications } from "../specifications.js";
import { currentLanguage, text } from "../texts.js";
import { reporter } from "../workers.js";
import { joinWords, reportWords } from "./words.js";

/** The samples and the file of limits, each {name, blob}; the report that is shown, {html, name, question}. */
const state = { samples: [], limits: null, report: null };

const value = (id) => byId(`laboratory-${id}`).value;

const filesNow = () => [...state.samples, ...(state.limits ? [state.limits] : [])];

const filesByName = () => Object.fromEntries(filesNow().map(({ name, blob }) => [name, blob]));

const newName = (name) => freeName(name, filesNow().map((file) => file.name));

function question() {
  return {
    samples: state.samples,
    specification: value("specification") || (state.limits?.name ?? ""),
    title: value("name"),
    client: value("client"),
    fields: value("fields"),
    liquid: value("liquid"),
    plastic: value("plastic"),
    language: currentLanguage(),
  };
}

function showRefusal(...content) {
  fill(byId("laboratory-message"), ...content);
}

/** What the program says is wrong. */
function refuse(err) {
  showRefusal(make("h3", {}, text("refused")), saidLines("pre", {}, err.trim()));
}

/** Runs the program; its files, or null where it refuses: then its words are shown. */
async function written(words, output) {
  showRefusal();
  try {
    const { files, err } = await reporter.run(words, filesByName());
    if (files[output]) return files[output];
    refuse(err);
  } catch (error) {
    showRefusal(make("p", {}, endInWords(error)));
  }
  return null;
}

function showReport() {
  const place = byId("laboratory-result");
  if (state.report === null) return fill(place);
  const frame = make("iframe", { class: "laboratory-report", title: text("laboratory.report"), sandbox: "allow-same-origin allow-modals", srcdoc: state.report.html });
  const button = (key, name, act) => {
    const made = make("button", { type: "button", "data-laboratory": name }, text(key));
    made.addEventListener("click", act);
    return made;
  };
  const buttons = make("p", { class: "buttons" },
    button("laboratory.save", "html", () => download(`${stem(state.report.name)}-report.html`, state.report.html)),
    button("laboratory.save.json", "json", saveJson),
    button("laboratory.print", "print", () => frame.contentWindow.print()));
  fill(place, buttons, frame);
}

async function saveJson() {
  const output = newName("report.json");
  const blob = await written(reportWords(state.report.question, output), output);
  if (blob) download(`${stem(state.report.name)}-report.json`, blob);
}

async function makeReport() {
  const asked = question();
  const output = newName("report.html");
  byId("laboratory-make").disabled = true;
  const blob = await written(reportWords(asked, output), output);
  state.report = blob && { html: await blob.text(), name: asked.samples[0].name, question: asked };
  onSamples();
  showReport();
}

async function join() {
  const asked = { coarse: value("coarse"), fine: value("fine"), at: value("at") };
  const output = newName(`${stem(asked.coarse)}-joined.csv`);
  const blob = await written(joinWords(asked, output), output);
  if (!blob) return;
  const parts = [asked.coarse, asked.fine];
  state.samples = [...state.samples.filter(({ name }) => !parts.includes(name)), { name: output, blob }];
  onSamples();
}

function removeButton(sample) {
  const button = make("button", { type: "button", class: "plain", "aria-label": text("blend.remove.of", { name: sample.name }) }, text("blend.remove"));
  button.addEventListener("click", () => {
    state.samples = state.samples.filter((one) => one !== sample);
    onSamples();
    byId("laboratory-files").focus();
  });
  return button;
}

/** There are other samples, or another language. */
function onSamples() {
  fill(byId("laboratory-samples"), ...state.samples.map((sample) => make("li", {}, make("span", {}, sample.name), " ", removeButton(sample))));
  const names = state.samples.map(({ name }) => name);
  for (const [place, chosen] of [["coarse", 0], ["fine", 1]]) {
    const list = byId(`laboratory-${place}`);
    const before = list.value;
    fill(list, ...names.map((name) => make("option", { value: name }, name)));
    list.hidden = false;
    list.value = names.includes(before) ? before : names[chosen] ?? "";
  }
  byId("laboratory-join").disabled = names.length < 2;
  byId("laboratory-make").disabled = names.length === 0;
}

function takeFiles(...files) {
  for (const file of files) state.samples.push({ name: newName(file.name), blob: file });
  onSamples();
}

function showLimits() {
  byId("laboratory-limits-name").textContent = state.limits?.name ?? text("laboratory.specification.none");
}

function takeLimits(file) {
  state.limits = null;
  state.limits = { name: newName(file.name), blob: file };
  byId("laboratory-specification").value = "";
  showLimits();
}

/** Writes the texts of this section again, in the language of the page. */
export function writeLaboratoryTexts() {
  onSamples();
  showLimits();
  showReport();
}

/** Makes the section work. */
export function startLaboratory() {
  offerSpecifications(byId("laboratory-specification"));
  onChoice(byId("laboratory-files"), takeFiles);
  onDrop(byId("laboratory-drop"), (files) => takeFiles(...files));
  onChoice(byId("laboratory-limits-file"), takeLimits);
  byId("laboratory-join").addEventListener("click", join);
  byId("laboratory-make").addEventListener("click", makeReport);
}
