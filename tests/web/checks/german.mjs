// On the German page the programs speak German where there are words of it, and what stays English says so.

import { join } from "node:path";

import { ROOT, Tab, fileOf } from "../support.mjs";

const siebung = join(ROOT, "examples/gradations/formats/siebung.csv");

const inGerman = (tab) => tab.click('[data-language="de"]');
const languages = (tab, selector) =>
  tab.page.$$eval(selector, (all) => all.map((one) => [one.lang, one.textContent]));

async function notesAreGerman({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.gradation(siebung);
  const english = await languages(tab, "#verdict .read li");
  expect(`English first: ${english}`, english.length > 1 && english.every(([lang]) => lang === "en"));
  await inGerman(tab);
  const german = await languages(tab, "#verdict .read li");
  expect(`as many: ${german}`, german.length === english.length && german.every(([lang]) => lang === "de"));
  const wanted = "Die Zeilen von 'Rückstand [g]' ergeben zusammen 500, wie 'Summe' sagt.";
  expect(`${german} has ${wanted}`, german.some(([, words]) => words === wanted));
  const read = await tab.text("#verdict .read");
  for (const part of ["Text mit ; zwischen den Zellen", "Spalte 'Siebweite [mm]', in mm", "Spalte 'Rückstand [g]': Masse"]) {
    expect(`${read} has ${part}`, read.includes(part));
  }
  await tab.click('[data-language="en"]');
  expect("and English again", JSON.stringify(await languages(tab, "#verdict .read li")) === JSON.stringify(english));
  await tab.close();
}

async function refusalsAreGerman({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.gradation(fileOf("bad.csv", "size_mm,passing_percent\n1,50\n2,40\n3,100\n"));
  await inGerman(tab);
  const [[lang, words]] = await languages(tab, "#message pre span");
  expect(`${lang}: ${words}`, lang === "de" && words.startsWith("bad.csv:3: ") && words.includes("Durchgang in Prozent 40"));
  expect("no language of the whole", (await languages(tab, "#message pre"))[0][0] === "");
  await tab.close();
}

async function whatHasNoGermanStaysEnglish({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await inGerman(tab);
  const [[lang]] = await languages(tab, "#verdict .verdict-line");
  expect(`the checker's line: ${lang}`, lang === "en");
  await tab.gradation(fileOf("bad.json", "{"));
  const lines = await languages(tab, "#message pre span");
  expect(`a line of JSON: ${lines}`, lines.length > 0 && lines.every((line) => ["de", "en"].includes(line[0])));
  await tab.close();
}

export const onPage = [notesAreGerman, refusalsAreGerman, whatHasNoGermanStaysEnglish];
