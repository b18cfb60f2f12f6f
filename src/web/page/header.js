// Whether a table begins with a header.

/** A number, the pan or a sieve's name, as the first cell of a row. */
const IS_SIZE = /^([<>≤≥]?\s*[\d.,#]|no\.?\s*\d|pan\b)/i;
const IS_NUMBER = /^[+-]?[\d.,]+\s*%?$/;

/** The number of columns of a table that begins without a header; 0 if it has one, or is no table. */
export function columnsWithoutHeader(content) {
  const first = content.split(/\r?\n/).find((line) => line.trim() !== "") ?? "";
  const delimiter = ["\t", ";", ","].find((one) => first.includes(one));
  if (delimiter === undefined) return 0;
  const cells = first.trim().split(delimiter).map((cell) => cell.trim().replace(/^"(.*)"$/, "$1"));
  return cells.length > 1 && IS_SIZE.test(cells[0]) && cells.slice(1).every((cell) => IS_NUMBER.test(cell)) ? cells.length : 0;
}
