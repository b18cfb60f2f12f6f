// The gradation's curve as the field draws it: percent passing over the size on a logarithmic axis.

import { Chart, linearAxis, logAxis } from "./chart.js";
import { unitName } from "./numbers.js";

const PERCENTS = [0, 20, 40, 60, 80, 100];
const MILLIMETRES = { mm: 1, um: 1e-3, m: 1e3, in: 25.4 };

/** The bands of both systems that are not parts of others. */
const MAIN_BANDS = ["clay", "silt", "fines", "sand", "gravel", "cobbles", "boulders", "large boulders"];

const MOST_CIRCLES = 60;

/** The bands of a classification, {name, above, up_to} in mm, with their names above the chart. */
function drawBands(chart, bands, low, high, unit, text) {
  const scale = MILLIMETRES[unit];
  const { top, bottom } = chart.area;
  for (const { name, above, up_to } of bands.filter((band) => MAIN_BANDS.includes(band.name))) {
    const from = Math.max(low, Number(above) / scale);
    const to = up_to === null ? high : Math.min(high, Number(up_to) / scale);
    if (to <= from) continue;
    const [x1, x2] = [chart.x.at(from), chart.x.at(to)];
    const label = text(`soil.${name}`);
    if (x2 - x1 > 7 * label.length + 8) chart.text((x1 + x2) / 2, top - 7, label, "middle");
    if (to < high) chart.line(x2, top - 20, x2, bottom, "chart-guide");
  }
}

/** The size at which the curve passes so many percent. */
function guide(chart, size, percent) {
  const [x, y] = [chart.x.at(size), chart.y.at(percent)];
  chart.add("path", { class: "chart-guide", d: `M${chart.area.left} ${y}H${x}V${chart.area.bottom}` });
  if (x - chart.area.left > 40) chart.text(chart.area.left + 6, y - 5, `D${percent}`);
}

/**
 * The chart of an answer's curve and steps; `description` may be null, and then there are no bands. `system` says whose
 * limits these have: `iso`, `uscs`, or `none` for no bands.
 */
export function curveChart({ answer, description, system, width, text }) {
  const height = Math.round(Math.min(430, Math.max(280, width * 0.6)));
  const sizes = [...answer.curve, ...answer.steps].map(([size]) => size);
  const low = Math.min(...sizes) / 1.15, high = Math.max(...sizes) * 1.15;
  const bands = description?.bands[system] ?? [];
  const xTitle = text("chart.size", { unit: unitName(answer.unit) });
  const chart = new Chart({
    width, height,
    label: text("chart.label", { id: answer.id }),
    xTitle: bands.length > 0 ? `${xTitle}; ${text("chart.bands", { system: text(`bands.${system}`) })}` : xTitle,
    yTitle: text("chart.passing"),
    margin: { top: 24 },
    axes: ({ left, right, top, bottom }) => ({
      x: logAxis(low, high, left, right),
      y: linearAxis(0, 100, bottom, top, PERCENTS),
    }),
  });
  drawBands(chart, bands, low, high, answer.unit, text);
  if (description && description.unit === answer.unit) {
    for (const percent of [10, 30, 60]) {
      const size = description[`D${percent}`];
      if (size && Number(size[0]) > low) guide(chart, Number(size[0]), percent);
    }
  }
  if (answer.steps.length > 0) chart.steps(answer.steps);
  chart.curve(answer.curve);
  if (answer.curve.length <= MOST_CIRCLES) chart.circles(answer.curve);
  return chart.svg;
}
