// What the programs say: in the page's language where there are words of it, else in English, and marked as such.

import table from "german/german.json";

import { make } from "./dom.js";
import { germanBy } from "./german.js";
import { currentLanguage } from "./texts.js";

const german = germanBy(table);

/** A text of a program, of a group of german.json, as {lang, words}. */
function inPageLanguage(words, group) {
  const found = currentLanguage() === "de" ? german(words, group) : null;
  return found === null ? { lang: "en", words } : { lang: "de", words: found };
}

/** A new element with what a program says; `properties` as of make. */
export function said(name, properties, words, group = "note") {
  const { lang, words: shown } = inPageLanguage(words, group);
  return make(name, { ...properties, lang }, shown);
}

/** The same of lines, each of which has its own language. */
export function saidLines(name, properties, words) {
  const lines = words.split("\n").map((line, i) => [...(i > 0 ? ["\n"] : []), said("span", {}, line)]);
  return make(name, properties, ...lines.flat());
}
