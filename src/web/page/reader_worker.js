// Reads what the programs write, so that the page itself never parses a long text: it asks for what it shows.

import { toDouble } from "./numbers.js";
import { sha256 } from "./sha256.js";

const ROWS = 200;
const SIEVES = 2000;

let answer = null;
let sample = null;
let tradeoff = null;

const json = async (blob) => JSON.parse(await blob.text());

/** At most so many of the items, the first and the last among them. */
function thinned(items, most) {
  if (items.length <= most) return items;
  return Array.from({ length: most }, (_, i) => items[Math.round((i * (items.length - 1)) / (most - 1))]);
}

/** The shares of the mass, in percent, that the gradation has in the classes. */
function targetShares({ classes }) {
  const masses = classes.map((one) => toDouble(one.mass));
  const total = masses.reduce((sum, mass) => sum + mass, 0);
  return masses.map((mass) => (100 * mass) / total);
}

/** The shares that the set has: the same in an exact match. */
function foundShares({ achieved, particles }, targets) {
  if (particles === null) return null;
  return achieved ? achieved.map((share) => 100 * toDouble(share)) : targets;
}

function classRows(from, count) {
  const { classes, targets, found } = answer;
  return classes.slice(from, from + count).map((one, i) => ({
    number: from + i + 1,
    lower: one.lower,
    upper: one.upper,
    target: targets[from + i],
    found: found && found[from + i],
    quantity: one.quantity,
    size: one.size,
  }));
}

function sampleRows(from, count) {
  return sample.classes.slice(from, from + count).map((one, i) => ({
    number: from + i + 1,
    lower: one.lower,
    upper: one.upper,
    quantity: one.quantity,
    target: 100 * toDouble(one.target),
    error: one.error_percent,
  }));
}

const tradeoffRow = ({ tolerance, smallest, lost, particles, lower_bound }) => ({
  tolerance, smallest, particles,
  lost: 100 * toDouble(lost),
  lowerBound: lower_bound,
});

/** The rows of the tables that may be long. */
const tables = {
  classes: classRows,
  sample: sampleRows,
  sieves: (from, count) => tradeoff.by_sieve.slice(from, from + count).map(tradeoffRow),
};

const operations = {
  async answer({ blob }) {
    answer = await json(blob);
    answer.targets = targetShares(answer);
    answer.found = foundShares(answer, answer.targets);
    const { id, status, particles, lower_bound, unit, notes, versions, tolerance, solids_volume } = answer;
    return {
      id, status, particles, lowerBound: lower_bound, unit, notes, versions,
      isTolerant: tolerance !== null,
      solidsVolume: solids_volume,
      classes: answer.classes.length,
      rows: classRows(0, ROWS),
    };
  },

  rows: ({ table, from, count }) => tables[table](from, count),

  /** The answer as `mdm solve --format csv` writes it. */
  csv() {
    const unit = answer.unit;
    const header = `lower_${unit},upper_${unit},mass,quantity,size_lo_${unit},size_hi_${unit}`;
    const lines = answer.classes.map(({ lower, upper, mass, quantity, size }) =>
      [lower, upper, mass, quantity ?? "", ...(size ?? ["", ""])].join(","),
    );
    return [header, ...lines, ""].join("\n");
  },

  async description({ blob }) {
    const { D10, D30, D60, Cu, Cc, uscs, unit, notes } = await json(blob);
    return { D10, D30, D60, Cu, Cc, uscs, unit, notes };
  },

  async reading({ blob }) {
    const { format, sizes, masses, unit, kind, classes, pan, canonical, samples, notes } = await json(blob);
    return { format, sizes, masses, unit, kind, classes, pan, canonical, samples, notes };
  },

  /** The sieves of a gradation, ascending. */
  async sieves({ blob }) {
    const { sizes, unit } = await json(blob);
    return { sizes: thinned(sizes, SIEVES), unit };
  },

  async tradeoff({ blob }) {
    tradeoff = await json(blob);
    const { kind, question, unit, by_tolerance, by_sieve, notes } = tradeoff;
    return {
      kind, question, unit, notes,
      byTolerance: by_tolerance.map(tradeoffRow),
      sieves: by_sieve.length,
      bySieve: tables.sieves(0, ROWS),
    };
  },

  async blend({ blob }) {
    const { status, stockpiles, sieves, steps, aim, blends, notes } = await json(blob);
    return { status, stockpiles, sieves, steps, aim, notes, shares: blends[0]?.shares ?? null };
  },

  async verification({ blob }) {
    sample = await json(blob);
    return {
      verdict: sample.verdict,
      sample: sample.sample,
      particles: sample.particles,
      smallest: sample.smallest,
      outside: sample.outside,
      unit: sample.unit,
      notes: [...sample.objections, ...sample.notes],
      classes: sample.classes.length,
      rows: sampleRows(0, ROWS),
    };
  },

  async digest({ blob }) {
    return sha256(new Uint8Array(await blob.arrayBuffer()));
  },
};

self.onmessage = async ({ data: { id, operation, ...parameters } }) => {
  if (id === undefined) return;
  try {
    self.postMessage({ id, result: await operations[operation](parameters) });
  } catch (error) {
    self.postMessage({ id, failure: String(error) });
  }
};
