// The controls of the question.

import { byId } from "./dom.js";
import { DEFAULTS, KINDS_WITH_VALUE, READING, SOIL, lengthInWords } from "./question.js";
import { text } from "./texts.js";

const form = () => byId("question");

/** What a decimal comma's user means. */
const NUMBERS = ["tolerance", "diameter", "height", "boxLength", "boxWidth", "voidRatio", "volume", "timeLimit", ...SOIL];

let sieves = { sizes: [], unit: "mm" };

/** The controls' values, by the names of DEFAULTS. */
export function readOptions() {
  const options = {};
  for (const name of Object.keys(DEFAULTS)) {
    const value = form().elements[name].value;
    options[name] = NUMBERS.includes(name) ? value.replace(",", ".") : value;
  }
  return options;
}

/** What differs from the defaults. */
export function changedOptions(options) {
  return Object.fromEntries(Object.entries(options).filter(([name, value]) => value !== DEFAULTS[name]));
}

/** Sets the controls; unknown names and values that are no strings are passed over. */
export function writeOptions(options) {
  for (const [name, value] of Object.entries(DEFAULTS)) {
    const given = options[name];
    form().elements[name].value = typeof given === "string" ? given : value;
  }
  for (const slider of form().querySelectorAll("[data-for]")) followField(slider);
  const changed = Object.keys(changedOptions(readOptions()));
  byId("reading").open = changed.some((name) => READING.includes(name));
  byId("soil").open = changed.some((name) => SOIL.includes(name));
  showParts();
  showCut();
}

function followField(slider) {
  slider.value = form().elements[slider.dataset.for].value.replace(",", ".") || slider.min;
}

/** Shows the fields that belong to what is chosen. */
function showParts() {
  const { specimen, toleranceKind } = readOptions();
  for (const part of form().querySelectorAll("[data-shape]")) {
    part.hidden = !part.dataset.shape.split(" ").includes(specimen);
  }
  byId("tolerance-value").hidden = !KINDS_WITH_VALUE.includes(toleranceKind);
}

/** The sizes to cut at, from the finest: the last class is always kept. */
function showCut() {
  const slider = byId("cut-slider");
  const cuts = Math.max(0, sieves.sizes.length - 2);
  const cut = form().elements.cut.value;
  const index = sieves.sizes.findIndex((size) => size + sieves.unit === cut);
  slider.max = cuts;
  slider.disabled = cuts === 0;
  slider.value = Math.max(0, index);
  writeCut(cut);
}

function writeCut(cut) {
  const words = cut === "" ? text("cut.all") : lengthInWords(cut);
  byId("cut-value").textContent = words;
  byId("cut-slider").setAttribute("aria-valuetext", words);
}

/** Takes the sieves of a new gradation. A cut that is none of its sieves is dropped; says whether one was. */
export function takeSieves(found) {
  sieves = found;
  const cut = form().elements.cut;
  const isDropped = cut.value !== "" && !sieves.sizes.some((size) => size + sieves.unit === cut.value);
  if (isDropped) cut.value = "";
  showCut();
  return isDropped;
}

/**
 * What is said of one gradation is not said of another: how its file is read, the limits of its fines, and a cut at one
 * of its sieves.
 */
export function forgetFile() {
  for (const name of [...READING, ...SOIL]) form().elements[name].value = DEFAULTS[name];
  byId("reading").open = byId("soil").open = false;
  takeSieves({ sizes: [], unit: "mm" });
}

/** Takes options of reading as if they were set by hand. */
export function takeReading(values) {
  for (const [name, value] of Object.entries(values)) form().elements[name].value = value;
  byId("reading").open = true;
  form().elements[READING[0]].dispatchEvent(new Event("input", { bubbles: true }));
}

export const writeControlTexts = showCut;

/** Makes the controls work; `onChange` is told of each change. */
export function startControls(onChange) {
  form().addEventListener("submit", (event) => event.preventDefault());
  form().addEventListener("input", (event) => {
    const { target } = event;
    if (target.dataset.for) form().elements[target.dataset.for].value = target.value;
    const slider = form().querySelector(`[data-for="${target.name}"]`);
    if (slider) followField(slider);
    if (target.id === "cut-slider") {
      const at = Number(target.value);
      form().elements.cut.value = at === 0 ? "" : sieves.sizes[at] + sieves.unit;
      writeCut(form().elements.cut.value);
    }
    showParts();
    onChange(event);
  });
  writeOptions({});
}
