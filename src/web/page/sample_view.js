// The verdict on a sample of particles.

import { byId, fill, make } from "./dom.js";
import { grouped, rounded, unitName } from "./numbers.js";
import { noteList } from "./reading_view.js";
import { pagedTable } from "./table.js";
import { text } from "./texts.js";

const VERDICTS = { match: "sample.match", "no match": "sample.no-match", undecided: "sample.undecided" };

/** Shows what mdm verify found, as the reader gives it; `fetchRows` gives further rows of its table. */
export function showSample(report, fetchRows) {
  const isMatch = report.verdict === "match";
  const smallest = [...new Set(report.smallest)].map(grouped).join(" – ");
  const line = text("sample.line", {
    particles: grouped(report.particles),
    smallest,
    outside: grouped(String(BigInt(report.outside.below) + BigInt(report.outside.above))),
  });
  const columns = [
    { title: text("class"), value: (row) => String(row.number), isHeader: true },
    { title: text("class.sizes", { unit: unitName(report.unit) }), value: (row) => `(${row.lower}, ${row.upper}]` },
    { title: text("class.quantity"), value: (row) => grouped(row.quantity) },
    { title: text("sample.target"), value: (row) => rounded(row.target) },
    { title: text("sample.error"), value: (row) => [row.error].flat().map((end) => rounded(Number(end), 3)).join(" – ") },
  ];
  const head = make("p", { class: "verdict-head" },
    make("span", { class: "sign", "aria-hidden": "true" }, isMatch ? "✓" : "✗"),
    make("strong", {}, text(VERDICTS[report.verdict])), `: ${report.sample}`);
  const notes = noteList(report.notes);
  if (notes) notes.className = "hint";
  fill(
    byId("sample-result"),
    make("div", { class: `verdict ${isMatch ? "accepted" : "rejected"}`, role: "status" }, head, make("p", {}, line)),
    pagedTable({ caption: text("sample.caption"), columns, rows: report.rows, count: report.classes, fetchRows }),
    notes,
  );
}
