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

check(cases, germanBy(table));
const german = germanBy(read("../../src/text/german.json"));
check(notes, german);
check([[`GRAT_TYPE: ${"x".repeat(1989)}.`, null], [`GRAT_TYPE: ${"ä".repeat(995)}.`, null]], german);
let hostile = "The rows of ";
while (hostile.length < 1999) hostile += [": ", ", ", " is "][hostile.length % 3];
german(hostile);
console.log(`${cases.length + notes.length} cases, ${failures} failures`);
process.exit(failures > 0 || cases.length < 20 ? 1 : 0);
