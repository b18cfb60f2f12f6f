// Where the gradation comes from: a file, an example, a typed table or a link.

import { byId, make } from "./dom.js";
import { EXAMPLES } from "./examples.js";
import { onChoice, onDrop, plainName } from "./files.js";
import { byteSize } from "./numbers.js";
import { text } from "./texts.js";

const LONGEST_SHOWN = 100_000;
const BEGINNING = 2_000;
const TYPING_PAUSE = 350;

let gradation = null;
let changed = () => {};
let typing = null;
/** Whether nothing is left of the table that was there before it was edited. */
let isReplaced = false;

/** The gradation {name, blob, isTyped}. */
export const currentGradation = () => gradation;

function isText(bytes) {
  try {
    return !new TextDecoder("utf-8", { fatal: true }).decode(bytes).includes("\0");
  } catch {
    return false;
  }
}

/** Shows a gradation's text; one that cannot be edited as it is shows its beginning, and one of no text, as a workbook, nothing. */
async function show(blob) {
  const table = byId("table");
  const start = new Uint8Array(await blob.slice(0, LONGEST_SHOWN).arrayBuffer());
  if (gradation.blob !== blob) return;
  const isEditable = blob.size <= LONGEST_SHOWN && isText(start);
  const beginning = start.includes(0) ? start.subarray(0, 0) : start.subarray(0, BEGINNING);
  table.readOnly = !isEditable;
  table.value = new TextDecoder().decode(isEditable ? start : beginning);
  byId("not-shown").hidden = isEditable;
}

export function writeFileName() {
  const words = { name: gradation.name, size: byteSize(gradation.blob.size) };
  byId("file-name").textContent = `${text("table")}: ${text("file.current", words)}`;
  for (const button of document.querySelectorAll("#examples button")) {
    button.setAttribute("aria-pressed", String(button.dataset.name === gradation.name && !gradation.isTyped));
  }
}

/** Takes a gradation and shows it. */
export async function takeGradation(name, blob) {
  clearTimeout(typing);
  isReplaced = false;
  gradation = { name: plainName(name), blob, isTyped: false };
  writeFileName();
  await show(blob);
}

async function takeAndTell(name, blob) {
  await takeGradation(name, blob);
  changed(true);
}

function takeTyped() {
  const blob = new Blob([byId("table").value]);
  gradation = { name: "gradation.csv", blob, isTyped: true };
  writeFileName();
  changed(isReplaced);
  isReplaced = false;
}

/**
 * Makes the inputs work; `onChange(isAnother)` is told of each change; an edited table is no other one, but one that is
 * pasted in the place of all that was there is.
 */
export function startGradationInput(onChange) {
  changed = onChange;
  for (const { title, name, text: content } of EXAMPLES) {
    const button = make("button", { type: "button", class: "plain", "data-name": name }, title);
    button.addEventListener("click", () => takeAndTell(name, new Blob([content])));
    byId("examples").append(button);
  }
  onChoice(byId("gradation-file"), (file) => takeAndTell(file.name, file));
  onDrop(document.body, ([file]) => takeAndTell(file.name, file));
  onDrop(byId("gradation-drop"), ([file]) => takeAndTell(file.name, file));
  byId("table").addEventListener("paste", ({ target }) => {
    isReplaced ||= target.value.slice(0, target.selectionStart).trim() + target.value.slice(target.selectionEnd).trim() === "";
  });
  byId("table").addEventListener("input", ({ target }) => {
    isReplaced ||= target.value.trim() === "";
    clearTimeout(typing);
    typing = setTimeout(takeTyped, TYPING_PAUSE);
  });
  byId("edit").addEventListener("click", async () => {
    await takeAndTell("gradation.csv", new Blob(["size_mm,passing_percent\n"]));
    byId("table").focus();
  });
}

/** The example that the page opens with. */
export const firstExample = () => EXAMPLES[0];
