// What passes each sieve of the mix, beside the limits.

import { byId, fill, make } from "../dom.js";
import { pagedTable } from "../table.js";
import { text } from "../texts.js";
import { inDecimals } from "./fraction.js";

const isBroken = ({ above, below }) => Boolean(above ?? below);

/** Where the mix is, with the distance from a limit that is not kept. */
function verdictOf(row) {
  if (!row.isLeast && !row.isMost) return "";
  if (!isBroken(row)) return "✓";
  const words = row.above
    ? text("blend.above", { points: inDecimals(row.above) })
    : text("blend.below", { points: inDecimals(row.below) });
  return make("strong", { class: "broken" }, `✗ ${words}`);
}

const columns = () => [
  { title: text("blend.sieve"), value: ({ size }) => inDecimals(size), isHeader: true },
  { title: text("blend.least"), value: ({ least, isLeast }) => (isLeast ? inDecimals(least) : "–") },
  { title: text("blend.passing"), value: ({ passing }) => inDecimals(passing) },
  { title: text("blend.most"), value: ({ most, isMost }) => (isMost ? inDecimals(most) : "–") },
  { title: text("blend.distance"), value: verdictOf, isText: true },
];

/** Whether all limits are kept, in a sentence, with the value of what is to be least. */
function stateOf(rows, aim, value) {
  const broken = rows.filter(isBroken).length;
  const key = broken === 0 ? "blend.kept" : broken === 1 ? "blend.broken.one" : "blend.broken";
  return make("div", { class: `verdict ${broken === 0 ? "accepted" : "rejected"}` },
    make("p", {}, make("span", { class: "sign", "aria-hidden": "true" }, broken === 0 ? "✓" : "✗"),
      make("strong", {}, text(key, { count: broken }))),
    value === null ? "" : make("p", {}, `${text(`blend.value.${aim}`)}: ${inDecimals(value)}`));
}

/** Shows a mix that is judged. */
export function showMix(rows, aim, value) {
  fill(byId("blend-state"), stateOf(rows, aim, value));
  const coarseFirst = [...rows].reverse();
  fill(byId("blend-rows"), pagedTable({
    caption: text("blend.rows"), columns: columns(), rows: coarseFirst, count: coarseFirst.length,
    fetchRows: async (from, count) => coarseFirst.slice(from, from + count),
  }));
}

/** Shows that there is nothing to judge, and why. */
export function showNoMix(why) {
  fill(byId("blend-state"), why ? make("p", { class: "hint" }, why) : null);
  fill(byId("blend-rows"));
  fill(byId("blend-picture"));
}
