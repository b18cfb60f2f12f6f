// The gradation's curve as the field draws it: percent passing over the size on a logarithmic axis.

import { Chart, linearAxis, logAxis } from "./chart.js";
import { unitName } from "./numbers.js";

const PERCENTS = [0, 20, 40, 60, 80, 100];
const MILLIMETRES = { mm: 1, um: 1e-3, m: 1e3, in: 25.4 };

/** The names of ISO 14688 and the sizes, in mm, up to which they reach. */
const SOILS = [["clay", 0.002], ["silt", 0.063], ["sand", 2], ["gravel", 63], ["cobbles", 200], ["boulders", 630]];

const MOST_CIRCLES = 60;

function soilNames(chart, low, high, unit, text) {
  const scale = MILLIMETRES[unit];
  const { top, bottom } = chart.area;
  let from = low * scale;
  for (const [name, limit] of SOILS) {
    if (limit <= from) continue;
    const to = Math.min(limit, high * scale);
    const [x1, x2] = [chart.x.at(from / scale), chart.x.at(to / scale)];
    const label = text(`soil.${name}`);
    if (x2 - x1 > 7 * label.length + 8) chart.text((x1 + x2) / 2, top - 7, label, "middle");
    if (limit >= high * scale) return;
    chart.line(x2, top - 20, x2, bottom, "chart-guide");
    from = to;
  }
}

/** The size at which the curve passes so many percent. */
function guide(chart, size, percent) {
  const [x, y] = [chart.x.at(size), chart.y.at(percent)];
  chart.add("path", { class: "chart-guide", d: `M${chart.area.left} ${y}H${x}V${chart.area.bottom}` });
  if (x - chart.area.left > 40) chart.text(chart.area.left + 6, y - 5, `D${percent}`);
}

/** The chart of an answer's curve and steps; `description` may be null. */
export function curveChart({ answer, description, width, text }) {
  const height = Math.round(Math.min(430, Math.max(280, width * 0.6)));
  const sizes = [...answer.curve, ...answer.steps].map(([size]) => size);
  const low = Math.min(...sizes) / 1.15, high = Math.max(...sizes) * 1.15;
  const chart = new Chart({
    width, height,
    label: text("chart.label", { id: answer.id }),
    xTitle: text("chart.size", { unit: unitName(answer.unit) }),
    yTitle: text("chart.passing"),
    margin: { top: 24 },
    axes: ({ left, right, top, bottom }) => ({
      x: logAxis(low, high, left, right),
      y: linearAxis(0, 100, bottom, top, PERCENTS),
    }),
  });
  soilNames(chart, low, high, answer.unit, text);
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
