// The page: what is asked is answered at once, and the proof of the answer is checked.

import { solve } from "./answer.js";
import { numberInWords, numberMeaning, showClasses, showIndices, showNumber, startBar } from "./answer_view.js";
import { askedOptions, askingForm } from "./asking.js";
import { startBlend, writeBlendTexts } from "./blend/blend.js";
import {
  changedOptions, forgetFile, readOptions, startControls, takeReading, takeSieves, writeControlTexts, writeOptions,
} from "./controls.js";
import { curvePicture } from "./curve.js";
import { byId, fill, make } from "./dom.js";
import { startDownloads } from "./downloads.js";
import { forgetFindings, startFurther, writeFurtherTexts } from "./further.js";
import { currentGradation, firstExample, startGradationInput, takeGradation, writeFileName } from "./gradation_input.js";
import { startLaboratory, writeLaboratoryTexts } from "./laboratory/laboratory.js";
import { Latest } from "./latest.js";
import { questionOf } from "./link.js";
import { Stopped } from "./programs.js";
import { READING, SOIL, inWords, readingFlags, soilFlags } from "./question.js";
import { readInWords, readingView } from "./reading_view.js";
import { saidLines } from "./said.js";
import { choose, currentLanguage, text, writeTexts } from "./texts.js";
import { judge, showVerdict } from "./verdict.js";
import { checkers, helper, painter, reader, rowsOf, solver } from "./workers.js";

const LONGEST_MESSAGE = 4_000;
const SOON = 250;
const PATIENCE = 400;

/** What the page shows: the last solution, its question, verdict and soil; and what the last search knew. */
const state = { solution: null, options: null, verdict: null, described: null, problem: null };

/** What the soil of a gradation depends on beside it. */
const soilWords = (options) => [...readingFlags(options), ...soilFlags(options)].join(" ");

/** The soil of what the page shows, {description, message}: not that of another file, or of one that was read otherwise. */
function soil() {
  const { solution, described } = state;
  const isOfAnswer = described?.gradation === solution.gradation && described.words === soilWords(readOptions());
  return isOfAnswer ? described : { description: null, message: "" };
}

const words = (options) => inWords(options, text);
const fetchRows = rowsOf("classes");

function showQuestion(options) {
  byId("asked").textContent = words(options).asked;
}

/** What helps with a message: a question for what the file does not say and nobody has said. */
function helpWith(message) {
  const options = readOptions();
  const asked = askedOptions(message);
  if (asked.some((name) => options[name].trim())) {
    byId("reading").open = true;
    return make("p", { class: "hint" }, text("reading.see"));
  }
  return askingForm({ asked, content: byId("table").value, take: takeReading });
}

function showMessage(message) {
  if (!message) return fill(byId("message"));
  fill(byId("message"), helpWith(message), make("h3", {}, text("refused")), saidLines("pre", {}, message));
}

/** What was read for the answer, as it stands beside its verdict. */
function readOfAnswer() {
  const { solution, options } = state;
  return readingView(solution.reading, options, solution.answer.notes);
}

function announce(sentence) {
  byId("announcement").textContent = sentence;
}

function showSolution() {
  const { solution, options } = state;
  const { answer } = solution;
  showQuestion(options);
  showNumber(numberInWords(answer), answer.status === "none" ? "" : undefined);
  byId("meaning").textContent = numberMeaning(answer, words(options).meaning);
  fill(byId("message"));
  byId("details").hidden = false;
  byId("model-download").hidden = answer.particles === null;
  byId("proof-download").hidden = solution.proof === null;
  showSoil();
  showCurve();
  showClasses(answer, fetchRows);
}

function showSoil() {
  showIndices(soil(), state.solution.answer);
}

let wantedCurve = [];

/** Draws the curve, unless the one that was last asked for is the same. */
function showCurve() {
  const wanted = [state.solution, byId("curve").clientWidth, byId("bands").value, currentLanguage()];
  if (state.solution === null || wanted.every((one, i) => one === wantedCurve[i])) return;
  wantedCurve = wanted;
  drawing.request();
}

/** Shows that there is no answer, and why; the page goes on. */
function showProblem() {
  const { message, bounds, hint } = state.problem;
  byId("details").hidden = true;
  fill(byId("verdict"));
  showQuestion(readOptions());
  showNumber(bounds ? boundsInWords(bounds) : "–", bounds ? undefined : "");
  byId("meaning").textContent = hint ? text(hint) : "";
  showMessage(message);
  announce(hint ? text(hint) : "");
}

function boundsInWords({ least, particles }) {
  return numberInWords({ status: "unknown", particles: particles ?? null, lowerBound: least });
}

function setProblem(problem) {
  Object.assign(state, { solution: null, verdict: null, problem });
  showProblem();
}

/** Shows that a search goes on, with the bounds as they improve. */
function startSearching() {
  const show = (key) => {
    byId("searching").hidden = false;
    byId("searching-text").textContent = text(key);
    byId("answer").classList.add("outdated");
    fill(byId("message"));
  };
  const timer = setTimeout(() => show("solving"), SOON);
  return {
    progress: null,
    onProgress(progress) {
      this.progress = progress;
      show("searching");
      fill(byId("verdict"));
      showNumber(boundsInWords(progress));
      byId("meaning").textContent = text(progress.particles ? "bounds" : "bounds.least");
    },
    end() {
      clearTimeout(timer);
      byId("searching").hidden = true;
      byId("answer").classList.remove("outdated");
    },
  };
}

async function answerQuestion(isOutdated) {
  const options = readOptions();
  const search = startSearching();
  showQuestion(options);
  try {
    const solution = await solve({ gradation: currentGradation(), options }, (progress) => search.onProgress(progress));
    if (solution.answer === null) {
      setProblem({ message: solution.message.trim().slice(0, LONGEST_MESSAGE) });
      return;
    }
    Object.assign(state, { solution, options, verdict: null, problem: null });
    fill(byId("download-note"));
    showSolution();
    checking.request();
  } catch (error) {
    if (!(error instanceof Stopped)) {
      setProblem({ message: text("ended", { message: error.message }) });
    } else if (!isOutdated()) {
      setProblem({ message: "", bounds: search.progress, hint: search.progress ? "stopped" : "stopped.nothing" });
    }
  } finally {
    search.end();
    solver.warmUp();
  }
}

async function checkProof(isOutdated) {
  const { solution } = state;
  if (solution === null) return;
  const place = byId("verdict");
  place.className = "verdict";
  if (solution.proof === null) {
    fill(place, make("p", {}, text("verdict.none")), readOfAnswer());
    return;
  }
  fill(place, make("p", {}, text("verdict.checking")), readOfAnswer());
  try {
    const verdict = await judge(checkers, solution.checked, solution.proof);
    if (isOutdated() || state.solution !== solution) return;
    state.verdict = verdict;
    showVerdict(place, verdict, readOfAnswer());
    announce(`${numberInWords(solution.answer)} ${text("particles")}. ${text(`verdict.${verdict.outcome}`)}. ${readInWords(solution.reading)}`);
  } catch (error) {
    if (!(error instanceof Stopped)) fill(place, make("p", {}, text("ended", { message: error.message })));
  }
}

function showWork() {
  byId("answer").setAttribute("aria-busy", String([answering, checking, drawing].some(({ isRunning }) => isRunning)));
}

const answering = new Latest({
  job: answerQuestion,
  stop: () => solver.stop(),
  patience: PATIENCE,
  onChange: showWork,
});
const checking = new Latest({
  job: checkProof,
  stop: () => checkers.forEach(({ program }) => program.stop()),
  patience: PATIENCE,
  onChange: showWork,
});

async function drawCurve() {
  const { solution, options } = state;
  const place = byId("curve");
  if (solution === null || place.clientWidth === 0) return;
  try {
    const { picture, err } = await curvePicture(solution, options, place.clientWidth);
    if (state.solution === solution) fill(place, picture ?? saidLines("pre", { class: "message" }, err.trim()));
  } catch (error) {
    if (!(error instanceof Stopped)) fill(place, make("p", {}, text("ended", { message: error.message })));
  }
}

const drawing = new Latest({
  job: drawCurve,
  stop: () => painter.stop(),
  patience: PATIENCE,
  onChange: showWork,
});

/** Describes the gradation and finds its sieves, beside the answer. */
async function describeGradation() {
  const gradation = currentGradation();
  const options = readOptions();
  const files = { [gradation.name]: gradation.blob };
  const run = async (command, flags, operation) => {
    const output = `${gradation.name}.${command}.json`;
    const argv = [command, gradation.name, ...readingFlags(options), ...flags, "--format", "json", "-o", output];
    const { files: written, err } = await helper.run(argv, files);
    const blob = written[output];
    return { err, found: blob ? await reader.ask({ operation, blob }) : null };
  };
  try {
    const { found: sieves } = await run("convert", [], "sieves");
    if (gradation !== currentGradation()) return;
    if (takeSieves(sieves ?? { sizes: [], unit: "mm" })) answering.request();
    const { found: description, err } = await run("describe", soilFlags(options), "description");
    if (gradation !== currentGradation()) return;
    state.described = { gradation, words: soilWords(options), description, message: description ? "" : err.trim() };
    if (state.solution) showSoil();
  } catch {
    // The answer stands without a description.
  }
}

const describing = new Latest({
  job: describeGradation,
  stop: () => helper.stop(),
  patience: PATIENCE,
  onChange: () => {},
});

function onGradation(isAnother) {
  if (isAnother) {
    forgetFile();
    fill(byId("link-note"));
  }
  forgetFindings();
  answering.request();
  describing.request();
}

function onControls({ target }) {
  const isSoil = SOIL.includes(target.name);
  if (!isSoil) answering.request();
  if (isSoil || READING.includes(target.name)) describing.request();
}

function writeAll() {
  writeTexts();
  for (const button of document.querySelectorAll("[data-language]")) {
    button.setAttribute("aria-pressed", String(button.dataset.language === currentLanguage()));
  }
  writeControlTexts();
  writeFileName();
  writeFurtherTexts();
  writeBlendTexts();
  writeLaboratoryTexts();
  if (state.problem) showProblem();
  if (state.solution) {
    showSolution();
    if (state.verdict) showVerdict(byId("verdict"), state.verdict, readOfAnswer());
  }
}

/** Takes the question of the page's link; false if it has none that can be read. */
async function takeLink() {
  try {
    const question = await questionOf(location.hash.slice(1));
    if (question === null) return false;
    writeOptions(question.options);
    await takeGradation(question.name, new Blob([question.bytes]));
    return true;
  } catch {
    fill(byId("link-note"), make("p", {}, text("link.bad")));
    return false;
  }
}

async function takeExample() {
  const { name, text: content } = firstExample();
  await takeGradation(name, new Blob([content]));
}

async function start() {
  solver.warmUp();
  painter.warmUp();
  startBar();
  startControls(onControls);
  startGradationInput(onGradation);
  startDownloads({ state, soil, words, fetchRows, options: () => changedOptions(readOptions()) });
  startFurther({ state });
  startBlend();
  startLaboratory();
  byId("stop").addEventListener("click", () => solver.stop());
  for (const button of document.querySelectorAll("[data-language]")) {
    button.addEventListener("click", () => {
      choose(button.dataset.language);
      writeAll();
    });
  }
  window.addEventListener("hashchange", async () => {
    if (await takeLink()) onGradation(false);
  });
  if (!(await takeLink())) await takeExample();
  writeAll();
  onGradation(false);
  byId("bands").addEventListener("change", showCurve);
  new ResizeObserver(showCurve).observe(byId("curve"));
}

start();
