// The page's texts, in the language that is chosen.

import de from "./texts/de.js";
import en from "./texts/en.js";

const LANGUAGES = { en, de };

let language = navigator.language.startsWith("de") ? "de" : "en";

export const currentLanguage = () => language;

/** A text of the language, with {name} replaced by values.name. */
export function text(key, values = {}) {
  return LANGUAGES[language][key].replace(/\{(\w+)\}/g, (_, name) => values[name]);
}

/** Writes the texts of all elements that name one: data-text is a content, data-label a label, data-hint a placeholder. */
export function writeTexts() {
  document.documentElement.lang = language;
  document.title = text("title");
  for (const one of document.querySelectorAll("[data-text]")) one.textContent = text(one.dataset.text);
  for (const one of document.querySelectorAll("[data-label]")) one.setAttribute("aria-label", text(one.dataset.label));
  for (const one of document.querySelectorAll("[data-hint]")) one.placeholder = text(one.dataset.hint);
}

/** Changes the language; the caller writes the texts again. */
export function choose(chosen) {
  language = chosen;
}
