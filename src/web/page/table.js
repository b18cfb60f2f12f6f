// Tables of any length: the rows come in pages, the first at once, the others when they are asked for.

import { make } from "./dom.js";
import { text } from "./texts.js";

const PAGE = 200;
const SHOWN_FIRST = 24;

/** A row's cells; columns marked `isText` are aligned as words. */
function rowOf(columns, row) {
  const cells = columns.map(({ value, isText, isHeader }) => {
    const cell = make(isHeader ? "th" : "td", {}, value(row));
    if (isHeader) cell.scope = "row";
    if (isText) cell.className = "words";
    return cell;
  });
  return make("tr", {}, ...cells);
}

/**
 * A table of `count` rows, with a caption. `rows` are the first ones; `fetchRows(from, count)` gives a promise of the
 * others. Columns are {title, value(row)}.
 */
export function pagedTable({ caption, columns, rows, count, fetchRows }) {
  const head = make("tr", {}, ...columns.map(({ title, isText }) => {
    return make("th", { scope: "col", className: isText ? "words" : "" }, title);
  }));
  const body = make("tbody", {}, ...rows.slice(0, SHOWN_FIRST).map((row) => rowOf(columns, row)));
  const table = make("table", {}, make("caption", {}, caption), make("thead", {}, head), body);
  const scroller = make("div", { class: "scroll", tabIndex: 0, role: "region", "aria-label": caption }, table);
  let shown = Math.min(rows.length, SHOWN_FIRST);
  const whole = make("div", { class: "table" }, scroller);
  if (count <= shown) return whole;

  const state = make("span", { class: "hint" });
  const button = make("button", { type: "button", class: "plain" });
  const write = () => {
    state.textContent = text("more.of", { shown, all: count });
    button.textContent = text("more", { count: Math.min(PAGE, count - shown) });
    button.hidden = shown >= count;
  };
  button.addEventListener("click", async () => {
    button.disabled = true;
    const next = shown < rows.length ? rows.slice(shown, shown + PAGE) : await fetchRows(shown, PAGE);
    body.append(...next.map((row) => rowOf(columns, row)));
    shown += next.length;
    button.disabled = false;
    write();
  });
  write();
  whole.append(make("p", { class: "more" }, state, " ", button));
  return whole;
}
