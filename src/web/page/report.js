// The report: one page for printing, with all that is needed to do it again.

import { classColumns, numberInWords, numberMeaning, soilNotes } from "./answer_view.js";
import { curvePicture } from "./curve.js";
import { byId, fill, make } from "./dom.js";
import { roundedEnclosure, unitName } from "./numbers.js";
import { noteList, readingEntries } from "./reading_view.js";
import { checkersInWords } from "./verdict.js";
import { text } from "./texts.js";

/** The most classes of which all are shown, and how many are shown of more, so that the report stays one page. */
const MOST_ROWS = 20;
const SHOWN_ROWS = 10;
const PICTURE_WIDTH = 460;

/** The first and the last rows, where there are too many for a page. */
async function rowsForPage(answer, fetchRows) {
  if (answer.classes <= MOST_ROWS) return { first: answer.rows.slice(0, MOST_ROWS), last: [], leftOut: 0 };
  const half = SHOWN_ROWS / 2;
  return {
    first: answer.rows.slice(0, half),
    last: await fetchRows(answer.classes - half, half),
    leftOut: answer.classes - SHOWN_ROWS,
  };
}

function table(columns, { first, last, leftOut }) {
  const row = (one) => make("tr", {}, ...columns.map(({ value }) => make("td", {}, value(one))));
  const body = make("tbody", {}, ...first.map(row));
  if (leftOut > 0) {
    const note = make("td", { colSpan: columns.length, class: "words" }, text("report.left-out", { count: leftOut }));
    body.append(make("tr", {}, note), ...last.map(row));
  }
  const head = make("tr", {}, ...columns.map(({ title }) => make("th", { scope: "col" }, title)));
  return make("table", {}, make("thead", {}, head), body);
}

function soilLine({ D10, D30, D60, Cu, Cc, uscs, iso_14688: iso, unit }) {
  const named = { D10, D30, D60, C_u: Cu, C_c: Cc };
  const words = Object.entries(named)
    .filter(([, value]) => value)
    .map(([name, value]) => `${name} = ${roundedEnclosure(value)}${name.startsWith("D") ? " " + unitName(unit) : ""}`);
  if (uscs) words.push(`${uscs.symbol}, ${uscs.name}`);
  if (iso) words.push(`${iso.symbol} (ISO 14688-2)`);
  return words.join(";  ");
}

/** Writes the report of a solution; `verdict` and `description` may be null. */
export async function writeReport({
  solution, options, description, verdict, asked, meaning, digests, command, checkerVersion, fetchRows,
}) {
  const { answer, reading } = solution;
  const versions = [...Object.entries(answer.versions).map((one) => one.join(" ")), checkerVersion.trim()].join(", ");
  const titled = (title, ...value) => make("div", {}, make("dt", {}, title), make("dd", {}, ...value));
  const entry = (key, ...value) => titled(text(key), ...value);
  const isSolved = answer.status === "optimal";
  const facts = make(
    "dl", {},
    entry("report.question", asked),
    entry(isSolved ? "report.answer" : "report.bounds", make("strong", {}, numberInWords(answer)), make("br"),
      numberMeaning(answer, meaning)),
    entry("report.verdict", verdict
      ? `${text(`verdict.${verdict.outcome}`)}, ${checkersInWords(verdict.checkers)}: ${verdict.line}`
      : text("verdict.none")),
  );
  facts.append(...readingEntries(reading, options, answer.notes).map((row) => titled(...row)));
  if (description) {
    const assumed = noteList(soilNotes(description, answer));
    facts.append(entry("report.soil", soilLine(description), ...(assumed ? [assumed] : [])));
  }
  const sources = make(
    "dl", { class: "sources" },
    entry("report.digests", ...digests.flatMap(({ name, digest }) => [make("code", {}, `${digest}  ${name}`), make("br")])),
    entry("report.command", make("code", {}, command)),
    entry("report.versions", versions),
  );
  const { picture } = await curvePicture(solution, options, PICTURE_WIDTH);
  picture?.removeAttribute("width");
  picture?.removeAttribute("height");
  fill(
    byId("report"),
    make("h1", {}, text("report.title")),
    make("p", { class: "report-id" }, answer.id),
    facts,
    picture,
    table(classColumns(answer), await rowsForPage(answer, fetchRows)),
    sources,
  );
}
