// The answer on the page: the number in large, curve, index numbers and classes.

import { byId, fill, make } from "./dom.js";
import { enclosed, grouped, rounded, roundedEnclosure, unitName } from "./numbers.js";
import { noteList } from "./reading_view.js";
import { saidLines } from "./said.js";
import { pagedTable } from "./table.js";
import { text } from "./texts.js";

const INDICES = [
  ["D10", (unit) => ["D", "10", unit]],
  ["D30", (unit) => ["D", "30", unit]],
  ["D60", (unit) => ["D", "60", unit]],
  ["Cu", () => ["C", "u", ""]],
  ["Cc", () => ["C", "c", ""]],
];

/** The number of particles, or its bounds, in words for the eye. */
export function numberInWords({ status, particles, lowerBound }) {
  if (status === "optimal") return grouped(particles);
  if (status === "none") return "–";
  if (particles === null) return text("at-least", { least: grouped(lowerBound) });
  return text("between", { least: grouped(lowerBound), best: grouped(particles) });
}

/** What stands below the number. */
export function numberMeaning({ status, particles }, meaning) {
  if (status === "optimal") return meaning;
  if (status === "none") return text("none");
  return text("limit.reached", { meaning: text(particles === null ? "bounds.least" : "bounds") });
}

/** Writes a number in large, the smaller the longer it is. */
export function showNumber(words, unit = text(words === "1" ? "particle" : "particles")) {
  const number = byId("number");
  number.textContent = words;
  number.dataset.length = words.length > 26 ? "long" : words.length > 11 ? "medium" : "short";
  byId("number-unit").textContent = unit;
  byId("bar").textContent = `${words} ${unit}`;
}

/** Where the answer is out of sight, a bar below shows its number, so that a control's effect is seen. */
export function startBar() {
  const observer = new IntersectionObserver(([{ isIntersecting }]) => (byId("bar").hidden = isIntersecting));
  observer.observe(byId("headline"));
}

/** How notes on numbers begin that the page does not show. */
const NOT_SHOWN = /^(no )?(fineness modulus|k_H|k_KC|D\[3,2\]|group of AASHTO|the group index of AASHTO)/;

/** The notes of a description that the answer does not have. */
export const soilNotes = (description, answer) =>
  description.notes.filter((note) => !answer.notes.includes(note) && !NOT_SHOWN.test(note));

/** The soil's numbers with what they assume, or why there are none; what the gradation does not reach is left out. */
export function showIndices({ description, message }, answer) {
  const place = byId("indices");
  if (message) return fill(place, saidLines("pre", { class: "message" }, message));
  if (description === null) return fill(place);
  const list = make("dl", { class: "indices" });
  for (const [key, name] of INDICES) {
    if (!description[key]) continue;
    const [letter, index, unit] = name(unitName(description.unit));
    const value = roundedEnclosure(description[key]) + (unit && "\u202f" + unit);
    list.append(make("div", {}, make("dt", {}, letter, make("sub", {}, index)), make("dd", {}, value)));
  }
  for (const [system, group] of [["USCS", description.uscs], ["ISO 14688-2", description.iso_14688]]) {
    if (!group) continue;
    const words = make("span", { class: "hint", lang: "en" }, group.name);
    list.append(make("div", { class: "wide" }, make("dt", {}, system), make("dd", {}, group.symbol, " ", words)));
  }
  const notes = noteList(soilNotes(description, answer));
  if (notes) notes.className = "hint";
  fill(place, make("h3", { class: "away" }, text("indices")), list, notes);
}

/** The columns of the table of classes. */
export function classColumns(answer) {
  const unit = unitName(answer.unit);
  const isFound = answer.particles !== null;
  const columns = [
    { title: text("class"), value: (row) => String(row.number), isHeader: true },
    { title: text("class.sizes", { unit }), value: (row) => `(${row.lower}, ${row.upper}]` },
  ];
  if (isFound) columns.push({ title: text("class.quantity"), value: (row) => grouped(row.quantity) });
  columns.push({ title: text("class.mass"), value: (row) => rounded(row.target) });
  if (isFound && answer.isTolerant) columns.push({ title: text("class.found"), value: (row) => rounded(row.found) });
  if (isFound) {
    columns.push({ title: text("class.size", { unit }), value: (row) => (row.size ? enclosed(row.size) : "–") });
  }
  return columns;
}

export function showClasses(answer, fetchRows) {
  const table = pagedTable({
    caption: text("classes"),
    columns: classColumns(answer),
    rows: answer.rows,
    count: answer.classes,
    fetchRows,
  });
  fill(byId("classes"), table);
  const volume = answer.solidsVolume;
  const words = volume && text("volume", { volume: enclosed(volume), unit: unitName(answer.unit) });
  byId("volume-of-set").textContent = words ?? "";
}
