// The question: what the controls say, as options of the program and as words.

/** The controls' values where they ask for nothing. */
export const DEFAULTS = {
  toleranceKind: "retained",
  tolerance: "0",
  minimum: "1",
  cut: "",
  specimen: "none",
  diameter: "",
  height: "",
  boxLength: "",
  boxWidth: "",
  lengthUnit: "mm",
  voidRatio: "",
  volume: "",
  timeLimit: "",
  sample: "",
  columns: "",
  kind: "",
  unit: "",
  skip: "",
  loss: "",
  liquidLimit: "",
  plasticLimit: "",
};

/** The kinds of tolerance that have a value in percentage points. */
export const KINDS_WITH_VALUE = ["retained", "passing", "total"];

/** The controls that say how the file is read. */
export const READING = ["sample", "columns", "kind", "unit", "skip", "loss"];

/** Their options of the program, in the same order. */
export const READING_FLAGS = ["--specimen-id", "--columns", "--kind", "--unit", "--skip", "--loss"];

/** The controls about the soil of the file. */
export const SOIL = ["liquidLimit", "plasticLimit"];

const isZero = (text) => /^[+-]?0*[.,]?0*$/.test(text.trim());

/** Whether the question is about an exact match. */
export function isExact(options) {
  return KINDS_WITH_VALUE.includes(options.toleranceKind) && isZero(options.tolerance);
}

/** The shape as --specimen takes it, or null where a length is not there yet. */
export function shapeOf({ specimen, diameter, height, boxLength, boxWidth, lengthUnit }) {
  const lengths = { cylinder: [diameter, height], box: [boxLength, boxWidth, height] }[specimen];
  if (lengths === undefined || lengths.some((one) => one.trim() === "")) return null;
  return `${specimen}:${lengths.map((one) => one.trim() + lengthUnit).join("x")}`;
}

/** "5mm" as "5 mm". */
export const lengthInWords = (length) => length.replace(/(um|mm|m|in)$/, "\u202f$1").replace("um", "µm");

function shapeInWords(shape) {
  return shape.slice(shape.indexOf(":") + 1).split("x").map(lengthInWords).join(" × ");
}

function toleranceFlags(options) {
  if (isExact(options)) return [];
  if (!KINDS_WITH_VALUE.includes(options.toleranceKind)) return ["--tolerance", options.toleranceKind];
  return ["--tolerance", `${options.toleranceKind}:${options.tolerance.trim()}%`];
}

/** The options of the specimen, which solve and export take. */
export function specimenFlags(options) {
  if (options.specimen === "volume" && options.volume.trim()) return ["--solids-volume", options.volume.trim()];
  const shape = shapeOf(options);
  return shape && options.voidRatio.trim() ? ["--specimen", shape, "--void-ratio", options.voidRatio.trim()] : [];
}

/** The options that say how the file is read. */
export function readingFlags(options) {
  return READING.flatMap((name, i) => (options[name].trim() ? [READING_FLAGS[i], options[name].trim()] : []));
}

/** The options of describe about the soil. */
export function soilFlags({ liquidLimit, plasticLimit }) {
  return [
    ...(liquidLimit.trim() ? ["--liquid-limit", liquidLimit.trim()] : []),
    ...(plasticLimit.trim() ? ["--plastic-limit", plasticLimit.trim()] : []),
  ];
}

/** The options of the question but its tolerance, of which tradeoff has its own. */
export function conditionFlags(options) {
  const flags = [];
  if (options.minimum.trim() && options.minimum.trim() !== "1") flags.push("--min-per-class", options.minimum.trim());
  if (options.cut) flags.push("--cut-below", options.cut);
  flags.push(...specimenFlags(options));
  if (options.timeLimit.trim()) flags.push("--time-limit", options.timeLimit.trim());
  return flags;
}

/** The options of solve. */
export function solveFlags(options) {
  return [...toleranceFlags(options), ...conditionFlags(options), ...readingFlags(options)];
}

/** The question in words of the language that `text` speaks: what is asked, and what the answer means. */
export function inWords(options, text) {
  const conditions = [];
  if (options.minimum.trim() !== "1" && options.minimum.trim()) {
    conditions.push(text("asked.minimum", { count: options.minimum.trim() }));
  }
  const shape = shapeOf(options);
  if (shape && options.voidRatio.trim()) {
    const values = { size: shapeInWords(shape), ratio: options.voidRatio.trim() };
    conditions.push(text(`asked.${options.specimen}`, values));
  }
  if (options.specimen === "volume" && options.volume.trim()) {
    conditions.push(text("asked.volume", { volume: options.volume.trim() }));
  }
  if (options.cut) conditions.push(text("asked.cut", { size: lengthInWords(options.cut) }));
  const match = isExact(options)
    ? text("asked.exact")
    : text(`asked.${options.toleranceKind}`, { value: options.tolerance.trim() });
  return {
    asked: text("asked", { match, conditions: conditions.map((one) => ", " + one).join("") }),
    meaning: text(conditions.length > 0 ? "meaning.conditions" : isExact(options) ? "meaning.exact" : "meaning.tolerant"),
  };
}
