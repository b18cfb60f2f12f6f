// Asks for what a file does not say: each option of reading that the program's message names, with nothing chosen
// beforehand.

import { byId, make } from "./dom.js";
import { columnsWithoutHeader } from "./header.js";
import { READING, READING_FLAGS } from "./question.js";
import { text } from "./texts.js";

/** The options that a message asks for. */
export const askedOptions = (message) => READING.filter((_, i) => message.includes(READING_FLAGS[i]));

/** A control like that of the form, in which nothing is chosen; what is required has no value of its own. */
function field(name, isRequired) {
  const control = byId("question").elements[name].cloneNode(true);
  control.id = `asked-${name}`;
  control.required = isRequired;
  control.value = "";
  if (control.options && isRequired) control.options[0].textContent = text("ask.choose");
  const label = make("label", { htmlFor: control.id }, text(`reading.${name}`));
  return make("div", { class: "field" }, label, control);
}

/**
 * A form for the options that are `asked`; null if there are none. `take(values)` is given what is chosen. Of two columns
 * without a header the first has the sizes: only what they are is asked.
 */
export function askingForm({ asked, content, take }) {
  const columns = columnsWithoutHeader(content);
  if (asked.length === 0) return null;
  const names = !asked.includes("columns")
    ? asked
    : columns > 0 ? [...(columns > 2 ? ["columns"] : []), "unit", "kind"] : asked.filter((name) => name !== "skip");
  const hasHeader = columns === 0 && asked.includes("columns"); // it may say the rest
  const given = asked.includes("columns") && columns === 2 ? { columns: "1,2" } : {};
  const hint = columns > 0 ? text(columns === 2 ? "ask.two-columns" : "ask.columns") : text("ask.hint");
  const form = make(
    "form", { class: "asking" },
    make("h3", {}, text("ask")),
    make("p", { class: "hint" }, hint),
    ...names.map((name) => field(name, name === "columns" || !hasHeader)),
    make("button", {}, text("ask.take")),
  );
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    take({ ...given, ...Object.fromEntries(names.map((name) => [name, form.elements[name].value])) });
  });
  return form;
}
