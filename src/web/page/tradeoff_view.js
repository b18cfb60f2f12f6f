// The trade-off on the page: charts and tables of N over the tolerance and over the smallest sieve kept.

import { byId, fill, make } from "./dom.js";
import { grouped, rounded, unitName } from "./numbers.js";
import { noteList } from "./reading_view.js";
import { pagedTable } from "./table.js";
import { text } from "./texts.js";
import { sieveChart, toleranceChart } from "./tradeoff_chart.js";

function particles({ particles, lowerBound }) {
  return particles === null ? text("at-least", { least: grouped(lowerBound) }) : grouped(particles);
}

function half(chart, given) {
  const table = pagedTable(given);
  return make("div", {}, ...(chart ? [chart] : []), table);
}

/** Shows a trade-off, as the reader gives it; `fetchRows` gives further rows of the table by sieve. */
export function showTradeoff(tradeoff, fetchRows) {
  const place = byId("tradeoff-result");
  const width = Math.round(Math.min(place.parentElement.clientWidth, 1400));
  const each = width > 720 ? Math.floor((width - 40) / 2) : width;
  const unit = unitName(tradeoff.unit);
  const isDrawn = ({ particles }) => particles !== null && Number.isFinite(Number(particles));
  const [byTolerance, bySieve] = [tradeoff.byTolerance.filter(isDrawn), tradeoff.sieveCurve.filter(isDrawn)];
  const number = { title: text("class.quantity"), value: particles };
  const kind = text(`tolerance.${tradeoff.kind}`);
  const chartOf = (draw, rows, options) => (rows.length > 1 ? draw(rows, { width: each, text, ...options }) : null);
  const notes = noteList(tradeoff.notes);
  if (notes) notes.className = "hint";
  fill(
    place,
    tradeoff.question ? make("p", { class: "hint", lang: "en" }, tradeoff.question) : null,
    make(
      "div", { class: "halves" },
      half(chartOf(toleranceChart, byTolerance), {
        caption: `${text("tradeoff.by-tolerance")} (${kind})`,
        columns: [{ title: text("tradeoff.points"), value: (row) => row.tolerance, isHeader: true }, number],
        rows: tradeoff.byTolerance,
        count: tradeoff.byTolerance.length,
      }),
      half(chartOf(sieveChart, bySieve.filter(({ smallest }) => Number(smallest) > 0), { unit }), {
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
}
