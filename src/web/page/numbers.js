// Numbers and units as the page shows them. Exact numbers are strings; doubles are only drawn or rounded for the eye.

const THIN_SPACE = "\u202f";

/** "1234567" with thin spaces between groups of three. */
export function grouped(digits) {
  return digits.replace(/\B(?=(\d{3})+$)/g, THIN_SPACE);
}

/** A double with so many significant digits, without trailing zeros and without an exponent where it is short. */
export function rounded(value, digits = 4) {
  if (value === 0) return "0";
  const text = value.toPrecision(digits);
  const plain = text.includes("e") ? String(Number(text)) : text;
  return plain.includes(".") && !plain.includes("e") ? plain.replace(/\.?0+$/, "") : plain;
}

/** The double nearest to a fraction "p/q" or a decimal. */
export function toDouble(text) {
  const [numerator, denominator] = text.split("/");
  if (denominator === undefined) return Number(text);
  const scale = 10n ** 18n;
  return Number((BigInt(numerator) * scale) / BigInt(denominator)) / 1e18;
}

/** An enclosure [lo, hi] as its certain digits; an ellipsis says that more would follow. */
export function enclosed([lo, hi]) {
  return lo === hi ? lo : lo + "…";
}

/** An enclosure rounded for the eye. */
export function roundedEnclosure([lo, hi], digits = 4) {
  return rounded((Number(lo) + Number(hi)) / 2, digits);
}

/** A number of bytes. */
export function byteSize(bytes) {
  if (bytes < 1024) return `${bytes} B`;
  if (bytes < 1024 * 1024) return `${rounded(bytes / 1024, 3)} KiB`;
  return `${rounded(bytes / 1024 / 1024, 3)} MiB`;
}

/** A unit of length as it is written. */
export const unitName = (unit) => (unit === "um" ? "µm" : unit);

/** A number as its user writes it, with a decimal comma or point, with a point. */
export const withPoint = (text) => text.trim().replace(",", ".");
