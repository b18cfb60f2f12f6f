// The trade-off on the page: a picture and tables of N over the tolerance and over the smallest sieve kept.

import { byId, fill, make } from "./dom.js";
import { grouped, rounded, unitName } from "./numbers.js";
import { noteList } from "./reading_view.js";
import { drawn } from "./picture.js";
import { Stopped } from "./programs.js";
import { pagedTable } from "./table.js";
import { text } from "./texts.js";

function particles({ particles, lowerBound }) {
  return particles === null ? text("at-least", { least: grouped(lowerBound) }) : grouped(particles);
}

const MOST_WIDTH = 1240;
const FILE = "tradeoff.json";

/** Draws the trade-off of a file into a place; where no curve has a match nothing is drawn. */
async function draw(place, file) {
  try {
    const { picture } = await drawn([FILE], { [FILE]: file }, Math.min(place.clientWidth, MOST_WIDTH));
    fill(place, picture);
  } catch (error) {
    if (error instanceof Stopped) await draw(place, file);
  }
}

/** Shows a trade-off, as the reader gives it, with its file; `fetchRows` gives further rows of the table by sieve. */
export function showTradeoff(tradeoff, fetchRows) {
  const place = byId("tradeoff-result");
  const unit = unitName(tradeoff.unit);
  const number = { title: text("class.quantity"), value: particles };
  const kind = text(`tolerance.${tradeoff.kind}`);
  const picture = make("div", { class: "picture" });
  const notes = noteList(tradeoff.notes);
  if (notes) notes.className = "hint";
  fill(
    place,
    tradeoff.question ? make("p", { class: "hint", lang: "en" }, tradeoff.question) : null,
    picture,
    make(
      "div", { class: "halves" },
      pagedTable({
        caption: `${text("tradeoff.by-tolerance")} (${kind})`,
        columns: [{ title: text("tradeoff.points"), value: (row) => row.tolerance, isHeader: true }, number],
        rows: tradeoff.byTolerance,
        count: tradeoff.byTolerance.length,
      }),
      pagedTable({
        caption: text("tradeoff.by-sieve"),
        columns: [
          { title: text("tradeoff.smallest", { unit }), value: (row) => row.smallest, isHeader: true },
          { title: text("tradeoff.lost"), value: (row) => rounded(row.lost) },
          number,
        ],
        rows: tradeoff.bySieve,
        count: tradeoff.sieves,
        fetchRows,
      }),
    ),
    notes,
  );
  draw(picture, tradeoff.file);
}
