// Proofs and samples that a user brings are judged on the page.

import { readFileSync } from "node:fs";

import { Tab, examples, fileOf, folder, run } from "../support.mjs";

const { path: sand } = examples.find(({ name }) => name.startsWith("athabasca"));

function nativeProof(mdm) {
  const path = `${folder()}/sand.proof`;
  run(mdm, ["solve", sand, "--proof", path]);
  return path;
}

async function judged(tab, gradation, proof) {
  await tab.choose("#proof-gradation-file", gradation);
  await tab.choose("#proof-proof-file", proof);
  await tab.click("#proof-check");
  await tab.until("a verdict", () => document.querySelector("#proof-result .verdict-line") !== null);
  return tab.text("#proof-result");
}

async function proofsAreChecked({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const proof = nativeProof(mdm);
  expect("the native proof is accepted", (await judged(tab, sand, proof)).includes("Proof accepted"));

  const damaged = fileOf("damaged.proof", readFileSync(proof, "utf8").replace("particles 1485", "particles 1484"));
  const verdict = await judged(tab, sand, damaged);
  expect(`a damaged proof is refused: ${verdict}`, verdict.includes("Proof refused") && verdict.includes("does not prove"));

  const noProof = await judged(tab, sand, sand);
  expect("a file that is no proof is malformed", noProof.includes("cannot be checked"));
  await tab.close();
}

async function aMissingFileIsAskedFor({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.click("#proof-check");
  expect("both files are asked for", (await tab.text("#proof-result")).includes("Choose a gradation and a proof."));
  await tab.close();
}

async function samplesAreJudged({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const sample = `${folder()}/sand.data`;
  run(mdm, ["export", sand, "--to", "lammps", "-o", sample]);
  await tab.choose("#sample-file", sample);
  await tab.until("a verdict", () => document.querySelector("#sample-result .verdict") !== null);
  expect("the exported grains match", (await tab.text("#sample-result")).includes("The sample matches"));

  await tab.set("#sample-tolerance", "0");
  await tab.choose("#sample-file", fileOf("one.csv", "size_mm,quantity\n0.1,1\n"));
  await tab.until("the other verdict", () => /does not match/.test(document.querySelector("#sample-result").innerText));

  await tab.choose("#sample-file", fileOf("none.csv", "nothing here\n"));
  await tab.until("a message", () => document.querySelector("#sample-result .message") !== null);
  expect("the message names the file", (await tab.text("#sample-result")).includes("none.csv"));
  await tab.change(() => tab.click('#examples [data-name="hostun-rf-sand.csv"]'));
  expect("it goes with its gradation", (await tab.text("#sample-result")) === "");
  await tab.close();
}

async function longTablesCanBeReadToTheirEnd({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  const classes = 220;
  const sizes = Array.from({ length: classes + 1 }, (_, i) => 1.05 ** i);
  const rows = sizes.map((size, i) => `${size.toPrecision(6)},${i < classes ? (size ** 3).toPrecision(6) : 0}`);
  await tab.gradation(fileOf("long.csv", ["size_mm,mass", ...rows, ""].join("\n")));
  await tab.choose("#sample-file", fileOf("one.csv", "size_mm,quantity\n1.04,1\n"));
  await tab.until("a verdict", () => document.querySelector("#sample-result .verdict") !== null);
  await tab.click("#tradeoff-run");
  await tab.until("the trade-off", () => document.querySelector("#tradeoff-result .halves") !== null);
  for (const place of ["#sample-result", "#tradeoff-result .halves > :last-child"]) {
    for (const shown of [200, classes]) {
      await tab.click(`${place} .more button`);
      await tab.until(`${shown} rows of ${place}`, (table, count) =>
        document.querySelectorAll(`${table} tbody tr`).length === count, place, shown);
    }
    expect(`nothing is left of ${place}`, await tab.page.$eval(`${place} .more button`, (one) => one.hidden));
  }
  await tab.close();
}

export const onPage = [proofsAreChecked, aMissingFileIsAskedFor, samplesAreJudged, longTablesCanBeReadToTheirEnd];
