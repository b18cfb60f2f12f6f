// Stockpiles are mixed by sliders beside their limits, and the best mix is that of mdm blend.

import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";

import { freeName } from "../../../src/web/page/files.js";
import { compared, inDecimals, inFull, minus, parsed, plus, ratio, times } from "../../../src/web/page/blend/fraction.js";
import { problemOf, rowsOfMix, valueOfMix, withRest } from "../../../src/web/page/blend/mix.js";
import { ROOT, Tab, axeSource, fileOf, folder, run } from "../support.mjs";

const FOLDER = join(ROOT, "examples/08-blend");
const IMPOSSIBLE = join(FOLDER, "impossible");
const STOCKPILES = ["A.csv", "B.csv", "C.csv", "D.csv"];
const COSTS = ["7.00", "10.82", "9.51", "8.88"];
const COST_WORDS = ["--cost", "A=7.00,B=10.82,C=9.51,D=8.88"];
const spaces = (text) => text.replace(/\s+/g, " ").trim();

async function fractionsAreExact(expect) {
  expect("sums", inFull(plus(parsed("0.1"), parsed("0.2"))) === "3/10");
  expect("differences", inFull(minus(parsed("1/3"), parsed("1/2"))) === "-1/6");
  expect("products", inFull(times(ratio(2, 3), parsed("-1.5"))) === "-1");
  expect("order", compared(parsed("1/3"), parsed("0.3333")) > 0 && compared(parsed("0.50"), parsed("1/2")) === 0);
  const shown = ["61", "8.1167", "-2.50", "1/3", "-1/3", "2/3", "1/100000", "0"].map((one) => inDecimals(parsed(one)));
  expect(`shown: ${shown}`, shown.join() === "61,8.1167,-2.5,0.3333…,-0.3333…,0.6666…,1/100000,0");
  expect("no numbers", ["", "x", "1e5", "1,5", ".5", "1/0", "--1", "Infinity"].every((one) => parsed(one) === null));
}

async function namesDiffer(expect) {
  expect("the same name", freeName("A.csv", ["A.csv", "A-2.txt"]) === "A-3.csv");
  expect("signs of options", freeName("a,b=c.csv", []) === "a_b_c.csv");
  expect("folders", freeName("../x/-A.csv", []) === "A.csv");
}

async function aMixIsJudgedExactly(expect) {
  const stockpiles = [
    { name: "a", passing: ["0", "100"], cost: "1" },
    { name: "b", passing: ["100/3", "100"], cost: "5/2" },
  ];
  const sieves = [{ size: "1", least: "10", most: "25", target: "20" }, { size: "2", least: "100", most: "100", target: "100" }];
  const problem = problemOf({ stockpiles, sieves, steps: "100", aim: "cost" });
  const at = (text) => {
    const { shares } = withRest([parsed(text)]);
    return { shares, rows: rowsOfMix(problem, shares) };
  };
  const limit = at("1/4");
  expect("at a limit", inFull(limit.rows[0].passing) === "25" && !limit.rows[0].above && !limit.rows[0].below);
  expect("no side at 100 %", limit.rows[1].isLeast && !limit.rows[1].isMost);
  expect("above", inFull(at("24/100").rows[0].above) === "1/3");
  expect("below", inFull(at("1").rows[0].below) === "10");
  const value = (aim) => inFull(valueOfMix({ ...problem, aim }, limit.shares, limit.rows));
  expect("its cost", value("cost") === "17/8");
  expect("its deviations", value("deviation") === "5" && value("max-deviation") === "5" && value("squares") === "25");
  expect("no aim", valueOfMix({ ...problem, aim: "none" }, limit.shares, limit.rows) === null);
}

/** Chooses several files in an input. */
async function chooseAll(tab, selector, paths) {
  const input = await tab.page.$(selector);
  await input.uploadFile(...paths);
}

const rows = (tab, count) =>
  tab.until(`${count} stockpiles`, (all) => document.querySelectorAll(".blend-stockpile").length === all, count);

async function load(tab, from, names, limits = "limits.csv") {
  await chooseAll(tab, "#blend-files", names.map((name) => join(from, name)));
  await rows(tab, names.length);
  await tab.choose("#blend-limits-file", join(from, limits));
}

const judged = (tab) => tab.until("a judged mix", () => document.querySelector("#blend-rows table") !== null);

/** The page with the example's files and costs. */
async function openExample(open, url) {
  const tab = await Tab.open(open, url);
  await load(tab, FOLDER, STOCKPILES);
  await tab.set("#blend-aim", "cost");
  for (const [i, cost] of COSTS.entries()) await tab.set(`.blend-stockpile:nth-child(${i + 1}) .blend-cost input`, cost);
  await judged(tab);
  await tab.until("the costs", () => /cost: \d/.test(document.querySelector("#blend-state").textContent));
  return tab;
}

async function best(tab) {
  await tab.click("#blend-best");
  await tab.until("an end", () => document.querySelector("#blend-result > pre") !== null);
}

const shares = (tab) => tab.page.$$eval(".blend-stockpile input[inputmode]:not(label input)", (all) => all.map((one) => one.value));

function nativeBlend(mdm, from, names, words) {
  const argv = ["blend", ...names, "--spec", "limits.csv", "--quiet", ...words];
  return run(mdm, argv, { cwd: from });
}

async function theBestIsThatOfTheProgram({ expect, open, url, mdm, mdmCheck }) {
  const tab = await openExample(open, url);
  await best(tab);
  const answer = JSON.parse(nativeBlend(mdm, FOLDER, STOCKPILES, [...COST_WORDS, "--format", "json"]).out);
  const native = answer.blends[0].shares.map((one) => inDecimals(times(parsed("100"), parsed(one))));
  const found = await shares(tab);
  expect(`shares ${found}, not ${native}`, found.join() === native.join());
  const sliders = await tab.page.$$eval('.blend-stockpile input[type="range"]', (all) => all.map((one) => one.value));
  expect(`sliders ${sliders}`, sliders.join() === native.join());
  const state = await tab.text("#blend-state");
  expect(`state: ${state}`, state.includes("keeps all limits") && state.includes(inDecimals(parsed(answer.blends[0].value))));
  const words = nativeBlend(mdm, FOLDER, STOCKPILES, COST_WORDS).out;
  expect("the program's own words", (await tab.text(".blend-report")).trimEnd() === words.trimEnd());
  expect("its proof is accepted", (await tab.text("#blend-result .verdict")).includes("none has a lower cost than its 81167/10000"));

  const passing = answer.blends[0].passing.map((one) => inDecimals(parsed(one))).reverse();
  const shown = await tab.page.$$eval("#blend-rows tbody tr", (all) => all.map((row) => row.children[2].textContent));
  expect(`what passes: ${shown}, not ${passing}`, shown.join() === passing.join());

  const proof = await tab.download('[data-blend="proof"]', "proof.mdm");
  const check = run(mdmCheck, ["limits.csv", ...STOCKPILES, proof], { cwd: FOLDER });
  expect(`the downloaded proof: ${check.out}${check.err}`, check.code === 0 && check.out.startsWith("accepted"));
  const blended = await tab.download('[data-blend="blended"]', "blended.csv");
  const nativeFile = join(folder(), "mix.csv");
  nativeBlend(mdm, FOLDER, STOCKPILES, [...COST_WORDS, "--blended", nativeFile]);
  const data = (path) => readFileSync(path, "utf8").split("\n").filter((line) => !line.startsWith("#")).join("\n");
  expect("the blended gradation", data(blended) === data(nativeFile));
  await tab.until("the picture", () => document.querySelector("#blend-picture svg") !== null);
  expect(`no errors: ${tab.errors}`, tab.errors.length === 0);
  await tab.close();
}

async function slidersShowABrokenLimit({ expect, open, url }) {
  const tab = await openExample(open, url);
  const slider = (i) => `.blend-stockpile:nth-child(${i}) input[type="range"]`;
  for (const [i, value] of [[1, "62"], [2, "10"], [3, "28"]]) await tab.set(slider(i), value);
  expect("the rest", (await shares(tab)).join() === "62,10,28,0");
  const state = await tab.text("#blend-state");
  expect(`the rounded optimum breaks two limits: ${state}`, state.includes("breaks 2 limits"));
  const broken = await tab.page.$$eval("#blend-rows tr:has(.broken)", (all) =>
    all.map((row) => [row.children[0].textContent, row.children[4].textContent].join(": ")));
  // 62 % of 5.9, 10 % of 95.8 and 28 % of 95.2 are 39.894; 62 % of 2.2, 10 % of 31.2 and 28 % of 84.1 are 28.032.
  expect(`its distances: ${broken}`, broken.join("; ") === "5: ✗ 0.106 too little; 0.4: ✗ 0.032 too much");

  await tab.set(slider(1), "90");
  expect("more than 100 % is said", (await tab.text("#blend-sum")).includes("128 %"));
  expect("and not judged", (await tab.page.$("#blend-rows table")) === null && (await tab.text("#blend-state")).includes("not judged"));
  await tab.set(slider(1), "50");
  await judged(tab);
  expect("the sum", (await tab.text("#blend-sum")) === "Sum: 100 %");
  const field = ".blend-stockpile:nth-child(1) > input.short";
  for (const bad of ["much", "-1", "101", ""]) {
    await tab.set(field, bad);
    expect(`${bad} is no share`, (await tab.text("#blend-sum")).includes("is no share of A"));
  }
  await tab.set(field, "33,25");
  expect("a decimal comma, and the rest", (await shares(tab)).at(-1) === "28.75");
  expect("it is judged", (await tab.page.$("#blend-rows table")) !== null);
  expect(`no errors: ${tab.errors}`, tab.errors.length === 0);
  await tab.close();
}

async function anImpossibleBlendShowsItsContradiction({ expect, open, url, mdm, mdmCheck }) {
  const tab = await Tab.open(open, url);
  await load(tab, IMPOSSIBLE, ["A.csv", "B.csv"]);
  await judged(tab);
  const before = await shares(tab);
  await best(tab);
  const native = nativeBlend(mdm, IMPOSSIBLE, ["A.csv", "B.csv"], ["--minimise", "none"]);
  expect("there is none", native.code === 1 && native.out.includes("add up to 0 >= 7"));
  expect("the program's own words", (await tab.text(".blend-report")).trimEnd() === native.out.trimEnd());
  expect("its proof is accepted", (await tab.text("#blend-result .verdict")).includes("Proof accepted"));
  const proof = await tab.download('[data-blend="proof"]', "proof.mdm");
  expect("also by the native program", run(mdmCheck, ["limits.csv", "A.csv", "B.csv", proof], { cwd: IMPOSSIBLE }).code === 0);
  expect("the sliders stay", (await shares(tab)).join() === before.join());
  await tab.close();
}

async function badSheetsAreRefusedWithWords({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  await load(tab, FOLDER, ["A.csv", "B.csv"]);
  await judged(tab);
  for (const [name, content] of [["bad.csv", "size_mm,passing_percent\n18,100\n5,much\n"], ["none.csv", ""], ["text.csv", "nothing here\n"]]) {
    const path = fileOf(name, content);
    await tab.choose("#blend-files", path);
    await tab.until(`a message about ${name}`, (one) => document.querySelector("#blend-message").textContent.includes(one), name);
    const { code, err } = run(mdm, ["blend", path, "--spec", "limits.csv", "--quiet"], { cwd: FOLDER });
    const shown = await tab.text("#blend-message pre");
    expect(`${name}: ${shown}`, code === 2 && spaces(err).replaceAll(dirname(path) + "/", "").endsWith(spaces(shown)));
    expect("nothing is judged", (await tab.page.$("#blend-rows table")) === null);
    await tab.click(".blend-stockpile:nth-child(3) button");
    await judged(tab);
    expect("the message goes with its sheet", (await tab.text("#blend-message")) === "");
  }
  await tab.choose("#blend-limits-file", fileOf("bad-limits.csv", "size_mm,passing_min_percent,passing_max_percent\n18,50,much\n"));
  await tab.until("a message about limits", () => document.querySelector("#blend-message").textContent.includes("bad-limits.csv"));
  await tab.choose("#blend-limits-file", join(FOLDER, "limits.csv"));
  await judged(tab);
  await tab.set("#blend-step", "three");
  await tab.until("a message about steps", () => document.querySelector("#blend-message").textContent.includes("--step"));
  await tab.set("#blend-step", "0,5%");
  await judged(tab);
  await tab.set("#blend-aim", "cost");
  await tab.until("a message about costs", () => document.querySelector("#blend-message").textContent.includes("cost"));
  expect(`no errors: ${tab.errors}`, tab.errors.length === 0);
  await tab.close();
}

async function tablesArePastedAndSpecificationsChosen({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  const paste = async (name, path, button) => {
    await tab.set("#blend-name", name);
    await tab.set("#blend-table", readFileSync(path, "utf8"));
    await tab.click(button);
  };
  await paste("A", join(FOLDER, "A.csv"), "#blend-paste-stockpile");
  await paste("A", join(FOLDER, "C.csv"), "#blend-paste-stockpile");
  await rows(tab, 2);
  const names = await tab.page.$$eval(".blend-stockpile", (all) => all.map((one) => one.getAttribute("aria-label")));
  expect(`names that differ: ${names}`, names.join() === "A,A-2");
  await paste("limits", join(FOLDER, "limits.csv"), "#blend-paste-limits");
  await judged(tab);
  await tab.page.select("#blend-limits", "superpave-12.5");
  await tab.until("its sieves", () => /^19/m.test(document.querySelector("#blend-rows tbody")?.innerText ?? ""));
  await tab.set("#blend-aim", "deviation");
  await tab.set("#blend-target", "fuller:19mm");
  await tab.until("the deviations", () => /deviations from the curve/.test(document.querySelector("#blend-state").innerText));
  await best(tab);
  expect("a proof with a shipped specification", /Proof (accepted|refused)|There is no proof/.test(await tab.text("#blend-result .verdict")));
  await tab.click('[data-language="de"]');
  expect("German", (await tab.text("#blend-title")) === "Halden mischen" && (await tab.text("#blend-sum")) === "Summe: 100 %");
  expect(`no errors: ${tab.errors}`, tab.errors.length === 0);
  await tab.close();
}

async function everybodyCanUseIt({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.click("#blend-example");
  await judged(tab);
  await best(tab);
  await tab.page.evaluate(axeSource);
  const findings = await tab.page.evaluate(async () => {
    const { violations } = await window.axe.run(document.querySelector("#blend"));
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map((one) => one.html).join(" | ")}`);
  });
  expect(findings.join("\n"), findings.length === 0);
  await tab.page.focus(".blend-stockpile:nth-child(1) input[type='range']");
  await tab.page.keyboard.press("ArrowRight");
  expect("an arrow moves a share and the rest", (await shares(tab)).join() === "62,11,27,0");
  await tab.page.setViewport({ width: 375, height: 740 });
  const width = await tab.page.evaluate(() => document.documentElement.scrollWidth);
  expect(`${width} pixels`, width <= 375);
  const requests = tab.requests.filter((one) => !/^(file|blob|data):/.test(one));
  expect(`requests: ${requests}`, requests.length === 0);
  await tab.close();
}

export const alone = [fractionsAreExact, namesDiffer, aMixIsJudgedExactly];
export const onPage = [
  theBestIsThatOfTheProgram, slidersShowABrokenLimit, anImpossibleBlendShowsItsContradiction, badSheetsAreRefusedWithWords,
  tablesArePastedAndSpecificationsChosen, everybodyCanUseIt,
];
