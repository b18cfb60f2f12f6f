// The page's matcher has the cases of the C++ one: node tests/german/german_test.mjs

import { readFileSync } from "node:fs";

import { germanBy } from "../../src/web/page/german.js";

const read = (path) => JSON.parse(readFileSync(new URL(path, import.meta.url), "utf8"));
const { table, cases, notes } = read("cases.json");
let failures = 0;

function check(all, german) {
  for (const [text, wanted] of all) {
    const found = german(text);
    if (found === wanted) continue;
    failures += 1;
    console.log(`${text}\n  is ${found}\n not ${wanted}`);
  }
}

/** The first row of a group that is not empty, and no list. */
const firstOf = (all, group) => all[group].find(([english]) => english !== "" && !english.includes(`{${group}}`));

/** An instance of a row in both languages, its places filled. */
function instance(all, [english, wanted]) {
  const contents = [];
  const inEnglish = english.replace(/\{([\w#]*)\}/g, (_, group) => {
    const part = group === "" ? ["'x'", "'x'"] : group === "#" ? ["7", "7"] : instance(all, firstOf(all, group));
    contents.push(part[1]);
    return part[0];
  });
  let place = 0;
  return [inEnglish, wanted.replace(/\{([\w#]*)\}/g, (_, name) => contents[/^\d/.test(name) ? name : place++])];
}

/** Each row has its own way, also behind the name of a file or a sample. */
function checkRows(all, german) {
  const rows = all.note.filter(([english]) => !english.includes("{note}"));
  const instances = rows.map((row) => instance(all, row));
  check(instances, german);
  check(instances.map((pair) => pair.map((text) => `a.csv:3: ${text}`)), german);
}

check(cases, germanBy(table));
const all = read("../../src/text/german.json");
const german = germanBy(all);
checkRows(all, german);
check(notes, german);
check([[`GRAT_TYPE: ${"x".repeat(1989)}.`, null], [`GRAT_TYPE: ${"ä".repeat(995)}.`, null]], german);
let hostile = "The rows of ";
while (hostile.length < 1999) hostile += [": ", ", ", " is "][hostile.length % 3];
german(hostile);
console.log(`${cases.length + notes.length} cases, ${failures} failures`);
process.exit(failures > 0 || cases.length < 20 ? 1 : 0);
