// What a program says in English, in German: src/text/german.cpp tells how, and does the same.

const MOST_BYTES = 2000;
const DEEPEST = 12;
const MOST_STEPS = 100_000;
const NUMBER = /^-?[0-9]+(\.[0-9]+)?$/;

/** A text cut at its places: pieces, one more than places, which are the words between the braces. */
function cut(text) {
  const parts = text.split(/\{([\w#]*)\}/);
  return { pieces: parts.filter((_, i) => i % 2 === 0), places: parts.filter((_, i) => i % 2 === 1) };
}

/** The rows of a table {GROUP: [[english, german], ...]}, those with the most letters first. */
function rowsOf(table) {
  const rows = Object.entries(table).flatMap(([group, texts]) =>
    texts.map(([english, german]) => ({ group, english: cut(english), german: cut(german) })));
  for (const row of rows) row.letters = row.english.pieces.join("").length;
  return rows.sort((a, b) => b.letters - a.letters);
}

/** False where a text has another beginning or end than a row. */
const mayMatch = ({ english: { pieces }, letters }, text) =>
  text.length >= letters && text.startsWith(pieces[0]) && text.endsWith(pieces.at(-1));

const inOrder = (row, contents) =>
  row.german.pieces.map((piece, i) => {
    const place = row.german.places[i];
    return piece + (place === undefined ? "" : contents[/^\d/.test(place) ? Number(place) : i]);
  }).join("");

/** A function that gives a text of a group in German, by a table; null for one that no row matches. */
export function germanBy(table) {
  const rows = rowsOf(table);
  let steps = 0;

  /** One row against one text: its German, null without a match, and whether there is another. */
  function matched(row, text, depth) {
    const { pieces, places } = row.english;
    const contents = [];
    const failed = new Set();
    let german = null;
    let isAmbiguous = false;

    function contentOf(place, found) {
      const group = places[place];
      if (group === "" || (group === "#" && NUMBER.test(found))) return found;
      return ofGroup(group, found, depth + 1);
    }

    /** All places are filled. */
    function take() {
      const found = inOrder(row, contents);
      isAmbiguous ||= german !== null && german !== found;
      german = found;
      return true;
    }

    /** Fills the places from `place` on with the text from `begin` on, in all ways; false if there is none. */
    function fill(place, begin) {
      if (place === places.length) return begin === text.length && take();
      if (failed.has(`${place} ${begin}`)) return false;
      const next = pieces[place + 1];
      const isLast = place + 1 === places.length;
      let isFilled = false;
      let end = isLast ? Math.max(begin, text.length - next.length) : begin;
      while ((end = text.indexOf(next, end)) >= 0 && !isAmbiguous && ++steps <= MOST_STEPS) {
        const content = contentOf(place, text.slice(begin, end));
        if (content !== null) {
          contents.push(content);
          if (fill(place + 1, end + next.length)) isFilled = true;
          contents.pop();
        }
        if (end === text.length) break; // where an empty piece is found again and again
        end += 1;
      }
      if (!isFilled) failed.add(`${place} ${begin}`);
      return isFilled;
    }

    fill(0, pieces[0].length);
    return { german, isAmbiguous };
  }

  function ofGroup(group, text, depth) {
    if (depth > DEEPEST) return null;
    for (const row of rows) {
      if (row.group !== group || !mayMatch(row, text) || (depth > 0 && row.english.places.includes("note"))) continue;
      const { german, isAmbiguous } = matched(row, text, depth);
      if (german !== null) return isAmbiguous ? null : german;
    }
    return null;
  }

  const bytes = (text) => new TextEncoder().encode(text).length;
  return (text, group = "note") => {
    steps = 0;
    const german = bytes(text) > MOST_BYTES ? null : ofGroup(group, text, 0);
    return steps > MOST_STEPS ? null : german;
  };
}
