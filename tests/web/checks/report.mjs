// The report for printing: one page with all that is needed to do it again.

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";

import { Tab, examples, fileOf, run } from "../support.mjs";

async function isOnePage(expect, tab) {
  const pdf = await tab.page.pdf({ format: "A4", printBackground: true, preferCSSPageSize: true });
  const pages = Buffer.from(pdf).toString("latin1").match(/\/Type\s*\/Page\b/g)?.length;
  expect(`${pages} pages`, pages === 1);
}

async function print(tab) {
  await tab.page.evaluate(() => {
    window.print = () => (window.printed = true);
    window.printed = false;
  });
  await tab.click("#print");
  await tab.until("the report", () => window.printed);
}

async function theReportIsOnePage({ expect, open, url, mdm, mdmCheck }) {
  const tab = await Tab.open(open, url);
  const { path } = examples.find(({ name }) => name.startsWith("ottawa"));
  await tab.change(() => tab.click('#examples [data-name="ottawa-f65-sand.csv"]'));
  await print(tab);
  const report = await tab.page.$eval("#report", (one) => one.textContent);
  const digest = createHash("sha256").update(readFileSync(path)).digest("hex");
  const version = run(mdmCheck, ["--version"]).out.split(" (")[0];
  for (const part of [version, "2\u202f498", digest, "accepted: N = 2498", "mdm solve ottawa-f65-sand.csv --proof", "gmp "]) {
    expect(`the report has ${part}`, report.includes(part));
  }
  const command = await tab.page.$$eval("#report code", (codes) => codes.at(-1).textContent);
  const words = command.split(" && ")[0].split(" ");
  const flags = words.slice(3, words.indexOf("--proof"));
  expect("the command repeats it", run(mdm, ["solve", path, ...flags]).out.includes("2498 particles"));
  if (open.name === "chromium") await isOnePage(expect, tab);
  await tab.close();
}

async function aLongReportIsOnePage({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  const rows = Array.from({ length: 100 }, (_, i) => `${(1.02 ** i).toFixed(4)},${1 + ((i * 7919) % 97)}`);
  const name = `a gradation with a name of many words, as laboratories give them.csv`;
  await tab.gradation(fileOf(name, ["size_mm,mass", ...rows, `${1.02 ** 100},0`, ""].join("\n")));
  const question = { "#minimum": "2", "#specimen": "box", "#boxLength": "50", "#boxWidth": "60", "#height": "70" };
  for (const [selector, value] of Object.entries(question)) await tab.set(selector, value);
  await tab.change(() => tab.set("#voidRatio", "0.6"));
  await print(tab);
  const left = await tab.page.$eval("#report", (one) => one.textContent);
  expect("what is left out is said", left.includes("90 classes are left out here"));
  if (open.name === "chromium") await isOnePage(expect, tab);
  await tab.close();
}

export const onPage = [theReportIsOnePage, aLongReportIsOnePage];
