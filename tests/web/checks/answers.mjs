// Each example, and each control, gives the number of the native program; what is downloaded is what it writes.

import { readFileSync } from "node:fs";
import { basename, dirname } from "node:path";

import { Tab, examples, fileOf, run } from "../support.mjs";

function nativeAnswer(mdm, path, flags = []) {
  return run(mdm, ["solve", path, ...flags, "--format", "json"]).out;
}

const particles = (answer) => JSON.parse(answer).particles;

async function examplesHaveTheirNumbers({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const offered = await tab.page.$$eval("#examples button", (buttons) => buttons.map((one) => one.dataset.name));
  expect("all examples are offered", examples.every(({ name }) => offered.includes(name)));
  for (const { name, path } of examples) {
    await tab.change(() => tab.click(`#examples [data-name="${name}"]`));
    const wanted = particles(nativeAnswer(mdm, path));
    expect(`${name}: ${await tab.number()}, not ${wanted}`, (await tab.number()) === wanted);
    expect(`${name}: accepted`, (await tab.text("#verdict")).includes(`accepted: N = ${wanted} is the smallest`));
    expect(`${name}: a curve`, (await tab.page.$eval("#curve svg", (one) => one.textContent)).includes("set of particles"));
  }
  expect(`no errors: ${tab.errors}`, tab.errors.length === 0);
  await tab.close();
}

const QUESTIONS = [
  { set: { "#tolerance-slider": "1" }, flags: ["--tolerance", "retained:1%"] },
  { set: { "#toleranceKind": "passing", "#tolerance": "0,5" }, flags: ["--tolerance", "passing:0.5%"] },
  { set: { "#toleranceKind": "laboratory" }, flags: ["--tolerance", "laboratory"] },
  { set: { "#minimum-slider": "10" }, flags: ["--min-per-class", "10"] },
  { set: { "#cut-slider": "3" }, flags: ["--cut-below", "0.15"] },
  {
    set: { "#specimen": "cylinder", "#diameter": "5", "#height": "9", "#voidRatio": "0.7" },
    flags: ["--specimen", "cylinder:5mmx9mm", "--void-ratio", "0.7"],
  },
  { set: { "#specimen": "volume", "#volume": "100" }, flags: ["--solids-volume", "100"] },
];

async function controlsAskTheQuestion({ expect, open, url, mdm }) {
  const sand = examples.find(({ name }) => name.startsWith("athabasca"));
  for (const { set, flags } of QUESTIONS) {
    const tab = await Tab.open(open, url);
    await tab.until("the sieves", () => Number(document.querySelector("#cut-slider").max) > 0);
    for (const [selector, value] of Object.entries(set)) await tab.set(selector, value);
    const wanted = particles(nativeAnswer(mdm, sand.path, flags));
    await tab.until(`${flags}: ${wanted}`, (number) =>
      document.querySelector("#number").textContent.replace(/\s/g, "") === number, wanted);
    await tab.settled();
    const verdict = await tab.text("#verdict");
    expect(`${flags}: accepted`, verdict.includes(`N = ${wanted} is the smallest`));
    await tab.close();
  }
}

async function otherFormatsAreRead({ expect, open, url, mdm }) {
  const folder = dirname(examples[0].path) + "/formats/";
  const tab = await Tab.open(open, url);
  for (const name of ["siebung.csv", "diggs.xml", "camsizer.xle", "coulter.$ls"]) {
    await tab.gradation(folder + name);
    const wanted = particles(nativeAnswer(mdm, folder + name));
    expect(`${name}: ${await tab.number()}, not ${wanted}`, (await tab.number()) === wanted);
  }
  await tab.gradation(folder + "mastersizer.csv");
  expect("a sample is asked for", (await tab.text("#message")).includes("What the file does not say"));
  await tab.change(() => tab.set("#sample-id", "Silt B"));
  const wanted = particles(nativeAnswer(mdm, folder + "mastersizer.csv", ["--specimen-id", "Silt B"]));
  expect(`Silt B: ${await tab.number()}, not ${wanted}`, (await tab.number()) === wanted);
  await tab.close();
}

async function downloadsAreTheProgramsOwn({ expect, open, url, mdm, mdmCheck }) {
  const tab = await Tab.open(open, url);
  const { path } = examples.find(({ name }) => name.startsWith("athabasca"));
  const proof = await tab.download('[data-download="proof"]', "athabasca-sand.proof");
  expect("the native checker accepts the proof", run(mdmCheck, [path, proof]).code === 0);

  const json = readFileSync(await tab.download('[data-download="json"]', "athabasca-sand.answer.json"), "utf8");
  const withoutVersions = (text) => JSON.stringify({ ...JSON.parse(text), versions: null });
  expect("the answer in JSON", withoutVersions(json) === withoutVersions(nativeAnswer(mdm, path)));

  const csv = readFileSync(await tab.download('[data-download="csv"]', "athabasca-sand.answer.csv"), "utf8");
  expect("the answer in CSV", csv === run(mdm, ["solve", path, "--format", "csv"]).out);

  const gradation = readFileSync(await tab.download('[data-download="gradation"]', "athabasca-sand.canonical.csv"), "utf8");
  expect("the canonical gradation", gradation === run(mdm, ["convert", path]).out);

  const svg = readFileSync(await tab.download('[data-download="svg"]', "athabasca-sand.svg"), "utf8");
  const answer = fileOf("athabasca-sand.answer.json", nativeAnswer(mdm, path));
  const caption = "Read: sizes in mm, percent passing.";
  const words = ["plot", path, answer, "--what", "curve", "--bands", "iso", "--caption", caption, "--format", "svg", "-o", "-"];
  expect("the picture", svg === run(mdm, words).out);
  const png = readFileSync(await tab.download('[data-download="png"]', "athabasca-sand.png"));
  expect("a PNG", png.subarray(1, 4).toString() === "PNG" && png.length > 10_000);
  await tab.close();
}

async function modelsAreWritten({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const { path } = examples.find(({ name }) => name.startsWith("athabasca"));
  for (const [engine, name] of [["liggghts", "liggghts.in"], ["lammps", "lammps.in"], ["yade", "yade.py"]]) {
    await tab.click(`[data-model="${engine}"]`);
    const model = `athabasca-sand-${name}`;
    await tab.until(model, (wanted) =>
      [...document.querySelectorAll("#download-note button")].some((one) => one.textContent === wanted), model);
    await tab.page.$$eval("#download-note button", (buttons, wanted) => {
      buttons.find((one) => one.textContent === wanted).id = "wanted-model";
    }, model);
    const written = readFileSync(await tab.download("#wanted-model", model), "utf8");
    const answer = fileOf("athabasca-sand.answer.json", nativeAnswer(mdm, path));
    const native = fileOf(model, "");
    run(mdm, ["export", basename(answer), "--to", engine, "--model", "settle", "-o", native], { cwd: dirname(answer) });
    expect(`${engine}: as the native program writes it`, written === readFileSync(native, "utf8"));
  }
  await tab.close();
}

async function theTradeoffIsComputed({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const { path } = examples.find(({ name }) => name.startsWith("athabasca"));
  await tab.click("#tradeoff-run");
  await tab.until("two tables", () => document.querySelectorAll("#tradeoff-result table").length === 2);
  const shown = (await tab.text("#tradeoff-result")).replace(/\u202f/g, "");
  const { by_tolerance, by_sieve } = JSON.parse(run(mdm, ["tradeoff", path, "--format", "json"]).out);
  for (const { particles } of [...by_tolerance, ...by_sieve]) {
    expect(`the trade-off has ${particles}`, new RegExp(`\\b${particles}\\b`).test(shown));
  }
  await tab.until("a picture", () => document.querySelector("#tradeoff-result svg") !== null);
  const picture = await tab.page.$eval("#tradeoff-result svg", (one) => one.textContent);
  expect("its curves", picture.includes("the smallest match within a tolerance") && picture.includes("mass lost"));
  await tab.click('[data-language="de"]');
  await tab.until("a German picture", () =>
    document.querySelector("#tradeoff-result svg")?.textContent.includes("die kleinste Menge innerhalb einer Toleranz"));
  await tab.close();
}

export const onPage = [
  examplesHaveTheirNumbers, controlsAskTheQuestion, otherFormatsAreRead, downloadsAreTheProgramsOwn, modelsAreWritten,
  theTradeoffIsComputed,
];
