// Exact numbers: fractions of integers of any length.

const gcd = (a, b) => {
  while (b !== 0n) [a, b] = [b, a % b];
  return a < 0n ? -a : a;
};

/** numerator / denominator in lowest terms; the denominator is above 0. */
function fraction(numerator, denominator) {
  const common = gcd(numerator, denominator);
  return { numerator: numerator / common, denominator: denominator / common };
}

export const ZERO = { numerator: 0n, denominator: 1n };
export const ONE = { numerator: 1n, denominator: 1n };
export const HUNDRED = { numerator: 100n, denominator: 1n };

/** The number that "p/q", "p" or a decimal says; null if the text is none. */
export function parsed(text) {
  const parts = /^(-?)(\d+)(?:\/([1-9]\d*)|\.(\d+))?$/.exec(text);
  if (parts === null) return null;
  const [, sign, whole, divisor, decimals = ""] = parts;
  const numerator = BigInt(whole + decimals);
  return fraction(sign ? -numerator : numerator, divisor ? BigInt(divisor) : 10n ** BigInt(decimals.length));
}

export const ratio = (numerator, denominator) => fraction(BigInt(numerator), BigInt(denominator));
export const plus = (a, b) =>
  fraction(a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator);
export const minus = (a, b) =>
  fraction(a.numerator * b.denominator - b.numerator * a.denominator, a.denominator * b.denominator);
export const times = (a, b) => fraction(a.numerator * b.numerator, a.denominator * b.denominator);
export const sum = (all) => all.reduce(plus, ZERO);

/** Below 0, 0 or above 0, as a is below, at or above b. */
export const compared = (a, b) => {
  const difference = a.numerator * b.denominator - b.numerator * a.denominator;
  return difference < 0n ? -1 : difference > 0n ? 1 : 0;
};

const MOST_DECIMALS = 4;

/** The first decimals of a number; "…" says that more would follow. */
function firstDecimals({ numerator, denominator }, decimals) {
  const scaled = (numerator * 10n ** BigInt(decimals)) / denominator;
  const isExact = scaled * denominator === numerator * 10n ** BigInt(decimals);
  const digits = String(scaled < 0n ? -scaled : scaled).padStart(decimals + 1, "0");
  const whole = digits.slice(0, digits.length - decimals);
  const rest = digits.slice(digits.length - decimals);
  const shown = isExact ? rest.replace(/0+$/, "") : rest;
  const sign = numerator < 0n ? "-" : "";
  return { text: sign + whole + (shown ? `.${shown}` : "") + (isExact ? "" : "…"), isNothing: scaled === 0n && !isExact };
}

/** A number as a decimal: exact where it is a short one, else its certain digits; a tiny one as "p/q". */
export function inDecimals(number) {
  const { text, isNothing } = firstDecimals(number, MOST_DECIMALS);
  return isNothing ? inFull(number) : text;
}

/** A number as "p/q", or "p". */
export const inFull = ({ numerator, denominator }) =>
  denominator === 1n ? String(numerator) : `${numerator}/${denominator}`;
