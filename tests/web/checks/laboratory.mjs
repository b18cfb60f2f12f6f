// The Report section: what it writes is what mdm report and mdm convert --join write.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { joinWords, reportWords } from "../../../src/web/page/laboratory/words.js";
import { ROOT, Tab, axeSource, fileOf, folder, run } from "../support.mjs";

const BLENDS = join(ROOT, "examples/08-blend");
const formats = join(ROOT, "examples/gradations/formats");
const HEAD = { title: "", client: "Müller & Co", fields: "Project=Quay = 2\n\nSampled=2026-05-04", liquid: "", plastic: "" };

async function wordsAreThoseOfTheProgram(expect) {
  const words = reportWords({ samples: [{ name: "a.csv" }], specification: "", ...HEAD, liquid: " 30,5", plastic: "20", language: "de" }, "r.html");
  expect(`words: ${words}`, words.join("|") ===
    "report|a.csv|--client=Müller & Co|--field=Project=Quay = 2|--field=Sampled=2026-05-04|--liquid-limit=30.5|--plastic-limit=20|--language=de|--quiet|-o|r.html");
  expect("JSON has no language", !reportWords({ samples: [], specification: "", ...HEAD, language: "de" }, "r.json").join().includes("language"));
  expect("joining", joinWords({ coarse: "a.csv", fine: "b.csv", at: "0,075mm" }, "j.csv").join(" ") ===
    "convert --join a.csv b.csv --at=0.075mm --quiet -o j.csv");
}

/** The page with files in the section. */
async function openWith(open, url, paths) {
  const tab = await Tab.open(open, url);
  const input = await tab.page.$("#laboratory-files");
  await input.uploadFile(...paths);
  await tab.until(`${paths.length} samples`, (count) => document.querySelectorAll("#laboratory-samples li").length === count, paths.length);
  return tab;
}

async function write(tab) {
  await tab.click("#laboratory-make");
  await tab.until("an end", () => !document.querySelector("#laboratory-make").disabled);
}

const native = (mdm, from, words) => run(mdm, words, { cwd: from });

async function theReportIsThatOfTheProgram({ expect, open, url, mdm }) {
  const tab = await openWith(open, url, [join(BLENDS, "A.csv"), join(BLENDS, "B.csv")]);
  await tab.page.select("#laboratory-specification", "superpave-12.5");
  await tab.set("#laboratory-client", HEAD.client);
  await tab.set("#laboratory-fields", HEAD.fields);
  for (const language of ["en", "de"]) {
    await tab.click(`[data-language="${language}"]`);
    await write(tab);
    const saved = await tab.download('[data-laboratory="html"]', "A-report.html");
    const out = join(folder(), "report.html");
    const words = reportWords({ samples: [{ name: "A.csv" }, { name: "B.csv" }], specification: "superpave-12.5", ...HEAD, language }, out);
    expect("the native program ends as a sample has it", [0, 1].includes(native(mdm, BLENDS, words).code));
    expect(`the same bytes, ${language}`, readFileSync(saved, "utf8") === readFileSync(out, "utf8"));
    const title = language === "de" ? "Bericht zur Korngrößenverteilung" : "Grain size report";
    const frame = await (await tab.page.$(".laboratory-report")).contentFrame();
    await tab.until("the report in its frame", () => document.querySelector(".laboratory-report")?.contentDocument?.querySelector("h1") !== null);
    expect("it is shown", (await frame.$eval("h1", (one) => one.textContent)) === title);
  }
  const json = await tab.download('[data-laboratory="json"]', "A-report.json");
  expect("and as JSON", JSON.parse(readFileSync(json, "utf8")).schema === "mdm-report-1");
  expect(`no errors: ${tab.errors}`, tab.errors.length === 0);
  await tab.close();
}

async function twoAnalysesAreJoined({ expect, open, url, mdm }) {
  const sieves = fileOf("sieves.csv", "size_mm,passing_percent\n4,100\n1,70\n0.075,30\n0,0\n");
  const hydrometer = fileOf("hydrometer.csv", "size_mm,passing_percent\n0.075,100\n0.02,40\n0.002,10\n0,0\n");
  const tab = await openWith(open, url, [sieves, hydrometer]);
  await tab.set("#laboratory-at", "2mm");
  await tab.click("#laboratory-join");
  await tab.until("a refusal", () => document.querySelector("#laboratory-message pre") !== null);
  expect("both are still there", (await tab.page.$$("#laboratory-samples li")).length === 2);
  await tab.set("#laboratory-at", "0,075mm");
  await tab.click("#laboratory-join");
  await tab.until("one sample", () => document.querySelectorAll("#laboratory-samples li").length === 1);
  expect("its name", (await tab.text("#laboratory-samples li span")) === "sieves-joined.csv");
  await write(tab);
  const saved = await tab.download('[data-laboratory="html"]', "sieves-joined-report.html");
  const from = folder();
  expect("joined natively", native(mdm, from, joinWords({ coarse: sieves, fine: hydrometer, at: "0.075mm" }, join(from, "sieves-joined.csv"))).code === 0);
  const words = reportWords({ samples: [{ name: "sieves-joined.csv" }], specification: "", ...HEAD, client: "", fields: "", language: "en" }, "r.html");
  expect("reported natively", native(mdm, from, words).code === 0);
  expect("the same report", readFileSync(saved, "utf8") === readFileSync(join(from, "r.html"), "utf8"));
  await tab.close();
}

async function badSamplesAreRefusedWithWords({ expect, open, url }) {
  const tab = await openWith(open, url, [fileOf("bad.csv", "size_mm,passing_percent\n1,much\n2,100\n")]);
  await write(tab);
  expect("the program's words", (await tab.text("#laboratory-message pre")).startsWith("bad.csv:2: "));
  expect("no report", (await tab.page.$(".laboratory-report")) === null);
  await tab.click("#laboratory-samples button");
  expect("nothing is left to report", await tab.page.$eval("#laboratory-make", (one) => one.disabled));
  await tab.choose("#laboratory-files", join(formats, "workbook.xlsx"));
  await write(tab);
  expect("a workbook has its report", (await tab.page.$(".laboratory-report")) !== null && (await tab.text("#laboratory-message")) === "");
  await tab.choose("#laboratory-limits-file", fileOf("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n1,50,much\n"));
  await write(tab);
  expect("bad limits", (await tab.text("#laboratory-message pre")).includes("limits.csv"));
  await tab.close();
}

async function everybodyCanReport({ expect, open, url }) {
  const tab = await openWith(open, url, [join(BLENDS, "A.csv")]);
  await write(tab);
  await tab.page.evaluate(axeSource);
  const findings = await tab.page.evaluate(async () => {
    const { violations } = await window.axe.run(document.querySelector("#laboratory"), { iframes: false });
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map((one) => one.html).join(" | ")}`);
  });
  expect(findings.join("\n"), findings.length === 0);
  await tab.page.setViewport({ width: 375, height: 740 });
  const width = await tab.page.evaluate(() => document.documentElement.scrollWidth);
  expect(`${width} pixels`, width <= 375);
  const requests = tab.requests.filter((one) => !/^(file|blob|data|about):/.test(one));
  expect(`requests: ${requests}`, requests.length === 0);
  await tab.close();
}

export const alone = [wordsAreThoseOfTheProgram];
export const onPage = [theReportIsThatOfTheProgram, twoAnalysesAreJoined, badSamplesAreRefusedWithWords, everybodyCanReport];
