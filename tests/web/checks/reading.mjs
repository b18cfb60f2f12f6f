// What is read of a file is said wherever its answer goes, is asked where the file does not say it, and is forgotten
// with the file.

import { readFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";

import { ROOT, Tab, examples, fileOf, run } from "../support.mjs";

const formats = join(ROOT, "examples/gradations/formats");
const siebung = join(formats, "siebung.csv");
const { path: athabasca } = examples.find(({ name }) => name.startsWith("athabasca"));

const particles = (mdm, path, flags = []) =>
  JSON.parse(run(mdm, ["solve", basename(path), ...flags, "--format", "json"], { cwd: dirname(path) }).out).particles;

const controls = (tab) =>
  tab.page.$$eval("#reading input, #reading select, #soil input", (all) => all.map((one) => one.value).join(""));

async function optionsGoWithTheirFile({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const unnamed = fileOf("unnamed.txt", "d;P\n2000;100\n1000;40\n500;10\n100;0\n");
  const take = async () => {
    await tab.gradation(unnamed);
    await tab.set("#unit", "um");
    await tab.set("#kind", "passing");
    await tab.set("#liquidLimit", "40");
    await tab.change(() => tab.set("#columns", "d,P"));
    expect("it is read as was said", (await tab.text("#verdict .read")).includes("--columns d,P --kind passing --unit um"));
  };
  const others = {
    "another file": () => tab.gradation(athabasca),
    "an example": () => tab.change(() => tab.click('#examples [data-name="hostun-rf-sand.csv"]')),
    "a table to type": () => tab.change(() => tab.click("#edit")),
    "a table in the place of all": () => tab.change(() => tab.page.$eval("#table", (table) => {
      table.setSelectionRange(0, table.value.length);
      table.dispatchEvent(new Event("paste", { bubbles: true }));
      table.value = "size_mm,mass\n1,2\n2,0\n";
      table.dispatchEvent(new Event("input", { bubbles: true }));
    })),
    "a table after none": () => tab.change(() => tab.page.$eval("#table", (table) => {
      for (const value of ["", "size_mm,mass\n1,2\n2,0\n"]) {
        table.value = value;
        table.dispatchEvent(new Event("input", { bubbles: true }));
      }
    })),
  };
  for (const [name, action] of Object.entries(others)) {
    await take();
    await action();
    expect(`${name}: nothing is left: ${await controls(tab)}`, (await controls(tab)) === "");
    expect(`${name}: nothing was said of it`, !(await tab.text("#verdict")).includes("--unit"));
  }
  await tab.gradation(athabasca);
  expect("it has its own answer", (await tab.number()) === particles(mdm, athabasca));
  await take();
  await tab.change(() => tab.page.$eval("#table", (table) => {
    table.value = table.value.replace("40", "41");
    table.dispatchEvent(new Event("input", { bubbles: true }));
  }));
  expect("an edit keeps them", (await tab.text("#verdict .read")).includes("--unit um"));
  await tab.close();
}

async function columnsWithoutAHeaderAreAskedFor({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const table = "4.75\t100\n2\t80\n0.425\t45\n0.075\t0\n";
  await tab.change(() => tab.set("#table", table));
  expect("no number is shown", (await tab.number()) === "–");
  expect("it is asked", (await tab.text("#message .asking")).includes("two columns and no header"));
  const chosen = await tab.page.$$eval(".asking select", (all) => all.map((one) => [one.name, one.value]));
  expect(`nothing is chosen: ${chosen}`, JSON.stringify(chosen) === '[["unit",""],["kind",""]]');
  await tab.click(".asking button");
  expect("it goes on asking", (await tab.page.$(".asking")) !== null && (await tab.number()) === "–");
  await tab.page.select("#asked-unit", "mm");
  await tab.page.select("#asked-kind", "passing");
  await tab.click(".asking button");
  await tab.until("an answer", () => document.querySelector("#verdict .verdict-line") !== null);
  await tab.settled();
  const wanted = particles(mdm, fileOf("gradation.csv", table), ["--columns", "1,2", "--kind", "passing", "--unit", "mm"]);
  expect(`${await tab.number()}, not ${wanted}`, (await tab.number()) === wanted);
  const read = await tab.text("#verdict .read");
  for (const part of ["in mm", "percent passing", "--columns 1,2 --kind passing --unit mm"]) {
    expect(`${read} has ${part}`, read.includes(part));
  }
  await tab.close();
}

async function aVerdictSaysWhatItIsAbout({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  await tab.gradation(siebung);
  const native = JSON.parse(run(mdm, ["convert", siebung, "--dry-run", "--format", "json"]).out);
  const has = (place, shown, parts) => parts.forEach((part) => expect(`${place}: ${shown} has ${part}`, shown.includes(part)));
  const parts = ["siebung.csv", native.format, native.sizes, native.masses, ...native.notes];
  const verdict = await tab.text("#verdict");
  has("verdict", verdict, ["Proof accepted", "in mm", "mass", ...parts]);
  expect("it is heard", (await tab.page.$eval("#announcement", (one) => one.textContent)).includes("sizes in mm"));

  await tab.page.evaluate(() => {
    window.print = () => (window.printed = true);
  });
  await tab.click("#print");
  await tab.until("the report", () => window.printed);
  has("report", await tab.page.$eval("#report", (one) => one.textContent), ["Proof accepted", ...parts]);

  const svg = readFileSync(await tab.download('[data-download="svg"]', "siebung.svg"), "utf8");
  const words = [...svg.matchAll(/<text[^>]*>([^<]*)</g)].map((one) => one[1]).join(" ");
  has("picture", words, ["Read: sizes in mm", "size (mm)", native.notes[0].replaceAll("&", "&amp;").split("'")[0].trim()]);

  await tab.click('[data-language="de"]');
  has("in German", await tab.text("#verdict"), ["Beweis angenommen", "Werte", "Schale", "Hinweise", "Gelesen als Text mit ;"]);
  await tab.close();
}

async function aCheckedProofSaysWhatWasRead({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const sand = fileOf("sand.csv", "size_um,passing_percent\n2000,100\n1000,40\n500,10\n");
  const proof = join(dirname(sand), "sand.proof");
  run(mdm, ["solve", sand, "--proof", proof]);
  await tab.choose("#proof-gradation-file", sand);
  await tab.choose("#proof-proof-file", proof);
  await tab.click("#proof-check");
  await tab.until("a verdict", () => document.querySelector("#proof-result .verdict-line") !== null);
  const shown = await tab.text("#proof-result");
  for (const part of ["Proof accepted", "in µm", "percent passing", "at size 0", "A pan of size 0 was added"]) {
    expect(`${shown} has ${part}`, shown.includes(part));
  }
  await tab.close();
}

async function aWorkbookIsReadAsItIs({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const workbook = join(formats, "workbook.xlsx");
  await tab.gradation(workbook);
  expect("its answer is that of the program", (await tab.number()) === particles(mdm, workbook));
  expect("its bytes are no table", (await tab.page.$eval("#table", (table) => table.readOnly && table.value)) === "");
  await tab.gradation(fileOf("broken.xlsx", "PK\x03\x04 and nothing behind it"));
  expect("a broken one is refused", (await tab.text("#message")).includes("broken.xlsx"));
  await tab.gradation(athabasca);
  expect("the page goes on", (await tab.number()) === "1485");
  await tab.close();
}

async function theChartNamesWhoseBandsItHas({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  const words = () => tab.page.$$eval("#curve text", (all) => all.map((one) => one.textContent));
  const bands = async (system, named) => {
    if (system) await tab.page.select("#bands", system);
    await tab.until(`bands of ${named}`, (one) => document.querySelector("#curve").textContent.includes(one), named);
  };
  await bands(null, "bands: ISO 14688");
  const iso = await words();
  expect(`ISO: ${iso}`, iso.includes("sand") && !iso.includes("fines"));
  await bands("uscs", "bands: ASTM D2487");
  const uscs = await words();
  expect(`USCS: ${uscs}`, uscs.includes("sand") && uscs.includes("fines"));
  await tab.page.select("#bands", "none");
  await tab.until("no bands", () => !document.querySelector("#curve").textContent.includes("bands"));
  expect("none", !(await words()).includes("sand"));
  await bands("iso", "bands: ISO 14688");
  await tab.click('[data-language="de"]');
  await bands(null, "Bereiche: ISO 14688");
  const german = await words();
  expect(`German: ${german}`, german.includes("Sand") && german.includes("Durchgang in Prozent"));
  await tab.close();
}

async function limitsOfTheFinesAreTaken({ expect, open, url, mdm }) {
  const tab = await Tab.open(open, url);
  const silty = fileOf("silty.csv", "size_mm,passing_percent\n4.75,100\n0.425,60\n0.075,20\n0.01,0\n");
  await tab.gradation(silty);
  await tab.until("SM", () => /SM/.test(document.querySelector("#indices").innerText));
  expect("what is assumed is said", (await tab.text("#indices")).includes("low-plasticity silt"));
  await tab.set("#liquidLimit", "40");
  await tab.until("a message", () => /go together/.test(document.querySelector("#indices").innerText));
  await tab.set("#plasticLimit", "20,5");
  const flags = ["--liquid-limit", "40", "--plastic-limit", "20.5", "--format", "json"];
  const { symbol } = JSON.parse(run(mdm, ["describe", silty, ...flags]).out).uscs;
  await tab.until(symbol, (wanted) => document.querySelector("#indices").innerText.includes(wanted), symbol);
  expect("nothing is assumed", !(await tab.text("#indices")).includes("low-plasticity silt"));
  expect("the answer stands", (await tab.number()) === particles(mdm, silty));
  await tab.close();
}

async function whatIsSaidOfASampleGoesWithIt({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  const sample = (name) => fileOf(name, "1 1 1 50\n2 2 2 100\n");
  await tab.choose("#sample-file", sample("first.txt"));
  await tab.until("a report", () => /first\.txt/.test(document.querySelector("#sample-result").innerText));
  await tab.page.select("#sample-unit", "um");
  await tab.choose("#sample-file", sample("second.txt"));
  await tab.until("a report", () => /second\.txt/.test(document.querySelector("#sample-result").innerText));
  expect("its unit is not the first one's", (await tab.page.$eval("#sample-unit", (one) => one.value)) === "");
  await tab.close();
}

export const onPage = [
  optionsGoWithTheirFile, columnsWithoutAHeaderAreAskedFor, aVerdictSaysWhatItIsAbout, aCheckedProofSaysWhatWasRead,
  aWorkbookIsReadAsItIs, theChartNamesWhoseBandsItHas, limitsOfTheFinesAreTaken, whatIsSaidOfASampleGoesWithIt,
];
