// What is no gradation gets the program's own message, as text, and the page goes on.

import { basename, dirname } from "node:path";

import { Tab, examples, fileOf, run } from "../support.mjs";

const masses = [
  "much", "", "NaN", "inf", "-inf", "1e999999999", "1e401", "-1", "0x10", "1_000", "1e", ".", "--1", "1.2.3", "1%",
  "a\tb", "é", "x".repeat(500), "1".repeat(1001),
];

const BAD_FILES = [
  ...masses.map((mass) => `size_mm,mass\n1,2\n2,${mass}\n3,0\n`),
  ...["fine", "", "NaN", "-1", "pans"].map((size) => `size_mm,mass\n${size},1\n2,1\n3,0\n`),
  "sieve,mass\nNo. 201,1\nNo. 4,0\n",
  "size_phi,mass\n1001,1\n2,0\n",
  "size_mm,passing_percent\n1,10\n2,101\n3,100\n",
  "size_mm,passing_percent\n1,50\n2,40\n3,100\n",
  "size_mm,cumulative_retained_percent\n1,101\n2,0\n",
  "size_mm,mass\n1,10\n2,1\n",
  "size_mm,mass\n1,0\n2,0\n",
  "size_mm,mass\n1,1\n2,1\n1.0,1\n3,0\n",
  "size_mm,mass,factor\n1,1,0\n2,0,1\n",
  "",
  "\n \n",
  "# nothing\n",
  "size_mm,mass\n",
  "d50,mass\n1,1\n2,0\n",
  "size_mm,mass\n1,1,1\n2,0\n",
  'size_mm,mass\n"1,1\n2,0\n',
  Buffer.from("7f454c460201010000", "hex"),
  Buffer.from("73697a655f6d6d2c6d6173730a312c320a322cff0a332c300a", "hex"),
  "size_mm,passing_min_percent,passing_max_percent\n1,0,10\n2,90,100\n",
];

const BAD_JSON = [
  "{", "{}", '{"sizes":[1,2]}', '{"sizes":[1,2],"masses":[1]}', '{"sizes":[1,2],"masses":[1e400,0]}',
  '{"sizes":[1,2],"masses":[NaN,0]}', '{"sizes":[1,2],"masses":["x",0]}', '{"sizes":[1,1],"masses":[1,0]}',
  '{"sizes":[1,2],"masses":[1,0],"unit":"furlong"}', '{"sizes":[1,2],"masses":[1,0],"id":[]}',
  '{"x":' + "[".repeat(100_000),
];

const spaces = (text) => text.replace(/\s+/g, " ").trim();

async function badGradationsGetTheirMessage({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const cases = [...BAD_FILES.map((text) => ["bad.csv", text]), ...BAD_JSON.map((text) => ["bad.json", text])];
  for (const [name, text] of cases) {
    const path = fileOf(name, text);
    const native = run(mdm, ["solve", basename(path), "--proof", "bad.proof"], { cwd: dirname(path) });
    expect(`${String(text).slice(0, 60)}: refused by the native program`, native.code === 2);
    await tab.gradation(path);
    const shown = await tab.text("#message pre");
    expect(`${String(text).slice(0, 60)}: ${shown}`, spaces(shown) === spaces(native.err));
    expect("no number stays", (await tab.number()) === "–");
  }
  await tab.change(() => tab.click('#examples [data-name="hostun-rf-sand.csv"]'));
  expect("the page goes on", (await tab.number()) === "31");
  expect(`no errors: ${tab.errors}`, tab.errors.length === 0);
  await tab.close();
}

async function badOptionsGetTheirMessage({ expect, open, url, mdm }) {
  const { path, name } = examples.find((one) => one.name.startsWith("athabasca"));
  const BAD_OPTIONS = [
    ["#tolerance", "much", ["--tolerance", "retained:much%"]],
    ["#tolerance", "-1", ["--tolerance", "retained:-1%"]],
    ["#minimum", "x", ["--min-per-class", "x"]],
    ["#minimum", "-3", ["--min-per-class", "-3"]],
    ["#timeLimit", "-1", ["--time-limit", "-1"]],
  ];
  for (const [selector, value, flags] of BAD_OPTIONS) {
    const tab = await Tab.open(open, url);
    await tab.change(() => tab.set(selector, value));
    const native = run(mdm, ["solve", name, ...flags], { cwd: dirname(path) });
    const shown = await tab.text("#message pre");
    expect(`${flags}: ${shown}`, native.code === 2 && spaces(shown) === spaces(native.err));
    await tab.close();
  }
}

export const onPage = [badGradationsGetTheirMessage, badOptionsGetTheirMessage];
