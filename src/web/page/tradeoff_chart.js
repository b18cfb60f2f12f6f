// The number of particles over the tolerance, and over the smallest sieve that is kept.

import { Chart, linearAxis, logAxis } from "./chart.js";

const HEIGHT = 280;

function decades(values) {
  const low = 10 ** Math.floor(Math.log10(Math.min(...values)));
  const high = 10 ** Math.ceil(Math.log10(Math.max(...values)));
  return [low, high > low ? high : 10 * low];
}

/** A chart of points [x, particles]; `xAxis(left, right)` makes its lower axis. */
function chartOf(points, { width, label, xTitle, yTitle, xAxis }) {
  const [low, high] = decades(points.map(([, particles]) => particles));
  const chart = new Chart({
    width, height: HEIGHT, label, xTitle, yTitle,
    margin: { left: 66 },
    axes: ({ left, right, top, bottom }) => ({ x: xAxis(left, right), y: logAxis(low, high, bottom, top) }),
  });
  chart.curve(points);
  chart.circles(points, "chart-dot", 3.5);
  return chart.svg;
}

export function toleranceChart(rows, { width, text }) {
  const points = rows.map(({ tolerance, particles }) => [Number(tolerance), Number(particles)]);
  const most = Math.max(...points.map(([tolerance]) => tolerance));
  return chartOf(points, {
    width,
    label: text("tradeoff.tolerance.label"),
    xTitle: text("tradeoff.tolerance"),
    yTitle: text("particles"),
    xAxis: (left, right) => linearAxis(0, most * 1.05, left, right, [0, 1, 2, 3, 4, 5].filter((one) => one <= most)),
  });
}

export function sieveChart(rows, { width, unit, text }) {
  const points = rows.map(({ smallest, particles }) => [Number(smallest), Number(particles)]).filter(([x]) => x > 0);
  const sizes = points.map(([size]) => size);
  return chartOf(points, {
    width,
    label: text("tradeoff.sieve.label"),
    xTitle: text("tradeoff.sieve", { unit }),
    yTitle: text("particles"),
    xAxis: (left, right) => logAxis(Math.min(...sizes) / 1.2, Math.max(...sizes) * 1.2, left, right),
  });
}
