// The Blend section: stockpiles and limits come in, sliders mix them, and the best mix is found.

import { byId, fill, make } from "../dom.js";
import { endInWords } from "../ends.js";
import { freeName, onChoice, onDrop, stem } from "../files.js";
import { Latest } from "../latest.js";
import { toDouble } from "../numbers.js";
import { Stopped } from "../programs.js";
import { saidLines } from "../said.js";
import { SPECIFICATIONS, offerSpecifications } from "../specifications.js";
import { text } from "../texts.js";
import { blender, reader } from "../workers.js";
import { findBest, forgetBest, writeBestTexts } from "./best.js";
import { showPicture } from "./drawing.js";
import { EXAMPLE } from "./files.js";
import { inFull, parsed } from "./fraction.js";
import { problemOf, rowsOfMix, valueOfMix } from "./mix.js";
import { showMix, showNoMix } from "./mix_view.js";
import { AIMS_WITH_TARGET, blendWords, filesOf } from "./question.js";
import { readShares, setShares, setSteps, showCosts, showSliders, startSliders, writeSliderTexts } from "./sliders.js";

const OUTPUT = "mdm-blend-problem.json";
const HEADER = 4_000;

/** The stockpiles {name, blob, cost, id}, of which `id` is what the program calls them; limits {name, blob}; what was read. */
const state = { stockpiles: [], limits: null, problem: null, refusal: "" };

const names = () => [...state.stockpiles, ...(state.limits ? [state.limits] : [])].map(({ name }) => name);

function question() {
  return {
    stockpiles: state.stockpiles,
    limits: state.limits,
    aim: byId("blend-aim").value,
    target: byId("blend-target").value,
    step: byId("blend-step").value,
  };
}

/** What is missing before there is anything to mix. */
function missing() {
  if (state.stockpiles.length === 0) return text("blend.missing.stockpiles");
  return state.limits === null ? text("blend.missing.limits") : "";
}

function showRefusal(err) {
  state.refusal = err.trim();
  fill(byId("blend-message"), ...(state.refusal ? [make("h3", {}, text("refused")), saidLines("pre", {}, state.refusal)] : []));
}

/** Shows the mix that the sliders say. */
function mix() {
  const { problem, stockpiles } = state;
  const { shares, problem: why } = stockpiles.length > 0 ? readShares() : {};
  byId("blend-sum").textContent = stockpiles.length === 0 ? "" : why ?? text("blend.sum");
  byId("blend-sum").classList.toggle("broken", Boolean(why));
  if (problem === null || why) {
    showNoMix(why ? text("blend.not-judged") : missing());
    return showPicture(null);
  }
  const rows = rowsOfMix(problem, shares);
  showMix(rows, problem.aim, valueOfMix(problem, shares, rows));
  showPicture({ question: question(), shares, coarsest: toDouble(inFull(rows.at(-1).size)) });
}

/** Reads stockpiles and limits: mdm blend is asked for its problem, and hardly for a search. */
async function read(isOutdated) {
  if (missing()) return;
  const asked = question();
  try {
    const words = [...blendWords(asked), "--node-limit", "1", "--quiet", "--format", "json", "-o", OUTPUT];
    const { files, err } = await blender.run(words, filesOf(asked));
    const found = files[OUTPUT] ? await reader.ask({ operation: "blend", blob: files[OUTPUT] }) : null;
    if (isOutdated()) return;
    state.problem = null;
    showRefusal(found === null ? err : "");
    if (found !== null) takeProblem(found);
  } catch (error) {
    state.problem = null;
    if (!(error instanceof Stopped)) fill(byId("blend-message"), make("p", {}, endInWords(error)));
  }
  mix();
}

function takeProblem(found) {
  state.problem = problemOf(found);
  state.stockpiles.forEach((one, i) => (one.id = state.problem.stockpiles[i].name));
  setSteps(state.problem.steps);
}

const reading = new Latest({ job: read, stop: () => {}, patience: 60_000, onChange: () => {} });

/** Something of the question is another. */
function onQuestion() {
  const aim = byId("blend-aim").value;
  byId("blend-target-field").hidden = !AIMS_WITH_TARGET.includes(aim);
  byId("blend-limits-name").textContent = state.limits?.name ?? text("blend.limits.none");
  byId("blend-best").disabled = Boolean(missing());
  showCosts(aim === "cost");
  forgetBest();
  if (missing()) {
    state.problem = null;
    showRefusal("");
  }
  mix();
  reading.request();
}

/** There are other stockpiles. */
function onStockpiles() {
  state.problem = null;
  showSliders(state.stockpiles, {
    remove(sheet) {
      state.stockpiles = state.stockpiles.filter((one) => one !== sheet);
      onStockpiles();
      byId("blend-files").focus();
    },
    cost(sheet, value) {
      sheet.cost = value;
      onQuestion();
    },
  });
  onQuestion();
}

function addStockpile(name, blob, cost = "") {
  const free = freeName(name, names());
  state.stockpiles.push({ name: free, blob, cost, id: stem(free) });
}

function setLimits(name, blob, chosen = "") {
  state.limits = null;
  state.limits = { name: freeName(name, names()), blob };
  byId("blend-limits").value = chosen;
}

/** Files with columns of least and most are limits. */
const isLimits = async (file) => /passing_(min|max)_percent/.test(await file.slice(0, HEADER).text());

async function takeFiles(...files) {
  for (const file of files) {
    if (await isLimits(file)) setLimits(file.name, file);
    else addStockpile(file.name, file);
  }
  onStockpiles();
}

function takeExample() {
  state.stockpiles = [];
  setLimits(EXAMPLE.limits.name, new Blob([EXAMPLE.limits.text]));
  for (const { name, text: content, cost } of EXAMPLE.stockpiles) addStockpile(name, new Blob([content]), cost);
  byId("blend-aim").value = "cost";
  byId("blend-step").value = "1%";
  onStockpiles();
}

function takeSpecification() {
  const chosen = byId("blend-limits").value;
  if (chosen) setLimits(`${chosen}.csv`, new Blob([SPECIFICATIONS[chosen]]), chosen);
  else state.limits = null;
  onQuestion();
}

function takePasted(take) {
  const name = byId("blend-name").value.trim() || text("blend.paste.unnamed");
  take(/\.\w+$/.test(name) ? name : `${name}.csv`, new Blob([byId("blend-table").value]));
  byId("blend-name").value = byId("blend-table").value = "";
}

async function best() {
  const asked = question();
  const shares = await findBest(asked);
  if (shares === null || state.problem === null) return;
  setShares(shares.map(parsed));
  mix();
}

/** Writes the texts of this section again, in the language of the page. */
export function writeBlendTexts() {
  writeSliderTexts();
  writeBestTexts();
  byId("blend-limits-name").textContent = state.limits?.name ?? text("blend.limits.none");
  showRefusal(state.refusal);
  mix();
}

/** Makes the section work. */
export function startBlend() {
  offerSpecifications(byId("blend-limits"));
  startSliders(mix);
  onChoice(byId("blend-files"), takeFiles);
  onDrop(byId("blend-drop"), (files) => takeFiles(...files));
  onChoice(byId("blend-limits-file"), (file) => {
    setLimits(file.name, file);
    onQuestion();
  });
  byId("blend-example").addEventListener("click", takeExample);
  byId("blend-limits").addEventListener("change", takeSpecification);
  for (const id of ["blend-aim", "blend-target", "blend-step"]) byId(id).addEventListener("input", onQuestion);
  byId("blend-paste-stockpile").addEventListener("click", () => {
    takePasted(addStockpile);
    onStockpiles();
  });
  byId("blend-paste-limits").addEventListener("click", () => {
    takePasted(setLimits);
    onQuestion();
  });
  byId("blend-best").addEventListener("click", best);
  byId("blend-best").disabled = true;
}
