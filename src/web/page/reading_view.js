// What was read of the gradation's file: it stands beside every verdict, since a proof is about what was read.

import { make } from "./dom.js";
import { READING, READING_FLAGS } from "./question.js";
import { unitName } from "./numbers.js";
import { said } from "./said.js";
import { text } from "./texts.js";

const MOST_NOTES = 20;

/** What the program says in its own words, which are of a group of german.json. */
const own = (words, group) => said("span", {}, words, group);

/** The options of reading as the user gave them. */
function saidInWords(options) {
  const given = READING.map((name, i) => [READING_FLAGS[i], options[name].trim()]).filter(([, value]) => value);
  return given.map((one) => one.join(" ")).join(" ");
}

/** The notes of a program as a list; null if there are none. */
export function noteList(notes) {
  if (notes.length === 0) return null;
  const items = notes.slice(0, MOST_NOTES).map((note) => said("li", {}, note));
  if (notes.length > MOST_NOTES) items.push(make("li", {}, text("notes.more", { count: notes.length - MOST_NOTES })));
  return make("ul", {}, ...items);
}

/** The notes of a report, with those of the reading that it lacks. */
export const notesWith = (notes, reading) => [...reading.notes.filter((note) => !notes.includes(note)), ...notes];

/** One line for those who hear the page. */
export function readInWords({ unit, kind }) {
  return text("read.line", { unit: unitName(unit), kind: text(`kind.${kind}`) });
}

/** What was read, as rows [title, ...content]: of `reading`, as the reader gives it, and the options that said how. */
function readingRows(reading, options) {
  const { name, format, unit, sizes, kind, masses, pan, classes } = reading;
  const said = saidInWords(options);
  return [
    [text("read.file"), `${name}: `, own(format, "format")],
    [text("read.sizes"), text("read.sizes.in", { unit: unitName(unit), classes }), " (", own(sizes, "source"), ")"],
    [text("read.values"), text(`kind.${kind}`), " (", own(masses, "source"), ")"],
    [text("read.pan"), text(pan ? "read.pan.yes" : "read.pan.no")],
    ...(said ? [[text("read.said"), make("code", {}, said)]] : []),
  ];
}

/** The notes, or that there are none. */
const notesOrNone = (notes) => noteList(notes) ?? text("notes.none");

/** What was read as a list of terms, with `notes`, those of the reading among them. */
export function readingView(reading, options, notes) {
  const entry = ([title, ...content]) => make("div", {}, make("dt", {}, title), make("dd", {}, ...content));
  const rows = [...readingRows(reading, options), [text("notes"), notesOrNone(notes)]];
  return make("dl", { class: "read", "aria-label": text("read") }, ...rows.map(entry));
}

/** The same in a paragraph and a list, for a report. */
export function readingEntries(reading, options, notes) {
  const [[, ...file], ...rows] = readingRows(reading, options);
  const rest = rows.flatMap(([title, ...content]) => [`; ${title}: `, ...content]);
  return [[text("read"), ...file, ...rest], [text("notes"), notesOrNone(notes)]];
}
