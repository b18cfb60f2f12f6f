// Charts as SVG: axes, curves, steps and points. Every text is set as text. Colours come from the page's style sheet
// by class names; a copy for a file has those of PRINTED instead.

const SVG = "http://www.w3.org/2000/svg";

const FEWEST_TICKS = 3;

/** What each class looks like in a file. */
const PRINTED = {
  "chart-grid": { stroke: "#dcdfe3", "stroke-width": "1" },
  "chart-grid-fine": { stroke: "#eef0f2", "stroke-width": "1" },
  "chart-frame": { stroke: "#8a929b", "stroke-width": "1", fill: "none" },
  "chart-text": { fill: "#3c4650", "font-family": "sans-serif", "font-size": "12" },
  "chart-curve": { stroke: "#1d2730", "stroke-width": "1.5", fill: "none" },
  "chart-point": { stroke: "#1d2730", "stroke-width": "1.25", fill: "#ffffff" },
  "chart-steps": { stroke: "#0b6470", "stroke-width": "2.25", fill: "none", "stroke-linejoin": "round" },
  "chart-dot": { fill: "#0b6470" },
  "chart-guide": { stroke: "#6b747d", "stroke-width": "1", "stroke-dasharray": "2 3", fill: "none" },
};

/** An SVG element with attributes and, if given, a text. */
export function element(name, attributes = {}, text = "") {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== "") made.textContent = text;
  return made;
}

/** An axis from the smallest to the largest value, `from` and `to` in pixels. */
export function linearAxis(low, high, from, to, steps) {
  const at = (value) => from + ((value - low) / (high - low)) * (to - from);
  return { at, ticks: steps.map((value) => ({ value, label: String(value) })), fine: [] };
}

/** The same with logarithms; its ticks are decades, with more between where there is room. */
export function logAxis(low, high, from, to) {
  const [a, b] = [Math.log10(low), Math.log10(high)];
  const at = (value) => from + ((Math.log10(value) - a) / (b - a)) * (to - from);
  const room = Math.abs(to - from) / Math.max(b - a, 1e-9);
  const labelled = room > 240 ? [1, 2, 4, 6] : room > 110 ? [1, 2, 5] : [1];
  const every = Math.max(1, Math.ceil(44 / room));
  const ticks = [], fine = [];
  for (let decade = Math.floor(a); decade <= Math.ceil(b); decade++) {
    for (let digit = 1; digit < 10; digit++) {
      const value = Number(`${digit}e${decade}`);
      if (value < low * (1 - 1e-9) || value > high * (1 + 1e-9)) continue;
      if (labelled.includes(digit) && decade % every === 0) ticks.push({ value, label: decadeLabel(value) });
      else if (room > 40) fine.push(value);
    }
  }
  return ticks.length >= FEWEST_TICKS ? { at, ticks, fine } : { at, ticks: roundTicks(low, high), fine: [] };
}

/** Multiples of 1, 2 or 5 times a power of ten, for an axis of less than a decade. */
function roundTicks(low, high) {
  const exact = (high - low) / 5;
  const decade = Math.floor(Math.log10(exact));
  const digit = [1, 2, 5, 10].find((one) => one * 10 ** decade >= exact);
  const step = digit * 10 ** decade;
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high; i++) {
    const value = Number((i * step).toPrecision(12));
    ticks.push({ value, label: String(value) });
  }
  return ticks;
}

function decadeLabel(value) {
  return value >= 1e6 || value < 1e-4 ? value.toExponential().replace("e+", "e") : String(value);
}

const path = (points) => points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");

/** A chart of width times height pixels, with `x` and `y` made by `axes(area)`. */
export class Chart {
  constructor({ width, height, label, xTitle, yTitle, margin = {}, axes }) {
    this.margin = { left: 52, right: 16, top: 14, bottom: 46, ...margin };
    this.area = {
      left: this.margin.left,
      right: width - this.margin.right,
      top: this.margin.top,
      bottom: height - this.margin.bottom,
    };
    this.svg = element("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": label });
    Object.assign(this, axes(this.area));
    this.#frame(xTitle, yTitle);
  }

  #frame(xTitle, yTitle) {
    const { left, right, top, bottom } = this.area;
    const vertical = (x, name) => this.line(x, top, x, bottom, name);
    const horizontal = (y, name) => this.line(left, y, right, y, name);
    this.x.fine.forEach((value) => vertical(this.x.at(value), "chart-grid-fine"));
    this.y.fine.forEach((value) => horizontal(this.y.at(value), "chart-grid-fine"));
    for (const { value, label } of this.x.ticks) {
      vertical(this.x.at(value), "chart-grid");
      this.text(this.x.at(value), bottom + 17, label, "middle");
    }
    for (const { value, label } of this.y.ticks) {
      horizontal(this.y.at(value), "chart-grid");
      this.text(left - 7, this.y.at(value) + 4, label, "end");
    }
    this.add("rect", { class: "chart-frame", x: left, y: top, width: right - left, height: bottom - top });
    this.text((left + right) / 2, bottom + 38, xTitle, "middle");
    const middle = (top + bottom) / 2;
    this.text(14, middle, yTitle, "middle").setAttribute("transform", `rotate(-90 14 ${middle})`);
  }

  add(name, attributes, text) {
    return this.svg.appendChild(element(name, attributes, text));
  }

  line(x1, y1, x2, y2, name) {
    return this.add("line", { class: name, x1, y1, x2, y2 });
  }

  text(x, y, text, anchor = "start") {
    return this.add("text", { class: "chart-text", x, y, "text-anchor": anchor }, text);
  }

  #pixels(points) {
    return points.map(([x, y]) => [this.x.at(x), this.y.at(y)]);
  }

  /** Straight lines from point to point. */
  curve(points) {
    this.add("path", { class: "chart-curve", d: path(this.#pixels(points)) });
  }

  /** What grows by jumps: level from each point to the next, from the left side to the right one. */
  steps(points) {
    const pixels = this.#pixels(points);
    const drawn = [[this.area.left, this.area.bottom]];
    for (const [x, y] of pixels) drawn.push([x, drawn.at(-1)[1]], [x, y]);
    drawn.push([this.area.right, drawn.at(-1)[1]]);
    this.add("path", { class: "chart-steps", d: path(drawn) });
  }

  circles(points, name = "chart-point", radius = 3) {
    for (const [cx, cy] of this.#pixels(points)) this.add("circle", { class: name, cx, cy, r: radius });
  }
}

const LINE = 16;

/** A text in lines of at most so many letters. */
function inLines(text, letters) {
  const lines = [];
  for (const word of text.split(" ")) {
    if (lines.length > 0 && lines.at(-1).length + word.length < letters) lines.push(`${lines.pop()} ${word}`);
    else lines.push(word);
  }
  return lines;
}

/** A copy of the chart for a file, with remarks below it. */
function printedCopy(svg, remarks) {
  const [width, height] = [svg.width.baseVal.value, svg.height.baseVal.value];
  const lines = remarks.flatMap((remark) => inLines(remark, Math.floor(width / 7)));
  const copy = svg.cloneNode(true);
  const whole = height + (lines.length > 0 ? (lines.length + 1) * LINE : 0);
  copy.setAttribute("xmlns", SVG);
  copy.setAttribute("height", whole);
  copy.setAttribute("viewBox", `0 0 ${width} ${whole}`);
  copy.insertBefore(element("rect", { width: "100%", height: "100%", fill: "#ffffff" }), copy.firstChild);
  lines.forEach((line, i) => copy.append(element("text", { class: "chart-text", x: LINE, y: height + (i + 1) * LINE }, line)));
  for (const one of copy.querySelectorAll("[class]")) {
    for (const [key, value] of Object.entries(PRINTED[one.getAttribute("class")])) one.setAttribute(key, value);
    one.removeAttribute("class");
  }
  return copy;
}

const asText = (svg) => new XMLSerializer().serializeToString(svg);

/** The chart as the text of an SVG file, with remarks below it. */
export const svgFile = (svg, remarks) => asText(printedCopy(svg, remarks));

/** The same as a PNG, with so many pixels for each of the chart's. */
export async function pngFile(svg, remarks, scale = 3) {
  const copy = printedCopy(svg, remarks);
  const url = URL.createObjectURL(new Blob([asText(copy)], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = copy.width.baseVal.value * scale;
    canvas.height = copy.height.baseVal.value * scale;
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
  } finally {
    URL.revokeObjectURL(url);
  }
}
