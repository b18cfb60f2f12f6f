// A mix of stockpiles of any shares: what passes each sieve of it, and how far that is from the limits, all exact.

import { HUNDRED, ONE, ZERO, compared, minus, parsed, plus, sum, times } from "./fraction.js";

/** The problem of a blend as mdm-blend-1 has it, with numbers for its texts. */
export function problemOf({ stockpiles, sieves, steps, aim }) {
  return {
    aim,
    steps: Number(steps),
    stockpiles: stockpiles.map(({ name, passing, cost }) => ({ name, passing: passing.map(parsed), cost: parsed(cost) })),
    sieves: sieves.map(({ size, least, most, target }) => ({
      size: parsed(size), least: parsed(least), most: parsed(most), target: target === null ? null : parsed(target),
    })),
  };
}

/** The shares with that of the last stockpile, which takes the rest: {shares, given}; `given` is what the others have. */
export function withRest(others) {
  const given = sum(others);
  return { shares: [...others, minus(ONE, given)], given };
}

const mean = (shares, values) => sum(shares.map((share, i) => times(share, values[i])));

/** How far a value is outside of its limits: {above} or {below}, or neither. */
function outside({ least, most }, value) {
  if (compared(value, least) < 0) return { below: minus(least, value) };
  if (compared(value, most) > 0) return { above: minus(value, most) };
  return {};
}

/** What passes each sieve, and {above} or {below} where a limit is not kept. */
export function rowsOfMix({ stockpiles, sieves }, shares) {
  return sieves.map((sieve, i) => {
    const passing = mean(shares, stockpiles.map((one) => one.passing[i]));
    return {
      ...sieve, passing,
      isLeast: compared(sieve.least, ZERO) > 0,
      isMost: compared(sieve.most, HUNDRED) < 0,
      ...outside(sieve, passing),
    };
  });
}

const distance = (a, b) => (compared(a, b) < 0 ? minus(b, a) : minus(a, b));

/** What the mix has of that which a blend is to have least of; null where it is to have nothing least. */
export function valueOfMix({ aim, stockpiles }, shares, rows) {
  const deviations = rows.filter(({ target }) => target !== null).map(({ passing, target }) => distance(passing, target));
  const values = {
    cost: () => mean(shares, stockpiles.map(({ cost }) => cost)),
    deviation: () => sum(deviations),
    "max-deviation": () => deviations.reduce((most, one) => (compared(one, most) > 0 ? one : most), ZERO),
    squares: () => deviations.reduce((all, one) => plus(all, times(one, one)), ZERO),
  };
  return values[aim]?.() ?? null;
}
