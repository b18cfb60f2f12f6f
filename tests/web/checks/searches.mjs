// A search without end shows its bounds, leaves the page usable and can be stopped; so does a long file.

import { Tab, fileOf } from "../support.mjs";

/** A gradation whose search within a tolerance takes longer than anybody waits. */
function longGradation() {
  const rows = Array.from({ length: 300 }, (_, i) => `${(1.013 ** i).toFixed(4)},${1 + ((i * 7919) % 997)}`);
  return ["size_mm,mass", ...rows, `${(1.013 ** 300).toFixed(4)},0`, ""].join("\n");
}

function manyClasses(count) {
  const rows = Array.from({ length: count }, (_, i) => `${(1 + i / 10_000).toFixed(4)},${1 + ((i * 7919) % 9)}`);
  return ["size_mm,mass", ...rows, `${2 + count / 10_000},0`, ""].join("\n");
}

async function aSearchIsStopped({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.gradation(fileOf("long.csv", longGradation()));
  await tab.set("#toleranceKind", "total");
  await tab.set("#tolerance", "0.5");
  await tab.until("the bounds", () => /\d.* to .*\d/.test(document.querySelector("#number").textContent));
  await tab.click('[data-language="de"]');
  expect("the page is usable", (await tab.text("#gradation-title")) === "Kornverteilung");
  await tab.click("#stop");
  await tab.until("the end", () => document.querySelector("#searching").hidden);
  expect("it says so", (await tab.text("#meaning")).includes("Angehalten"));
  expect("the bounds stay", /\d.* bis .*\d/.test(await tab.text("#number")));
  await tab.change(() => tab.click('#examples [data-name="hostun-rf-sand.csv"]'));
  await tab.change(() => tab.set("#tolerance", "0"));
  expect("the page goes on", (await tab.number()) === "31");
  await tab.close();
}

async function anOutdatedSearchEnds({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.gradation(fileOf("long.csv", longGradation()));
  await tab.set("#toleranceKind", "total");
  await tab.set("#tolerance", "0.5");
  await tab.until("the search", () => !document.querySelector("#searching").hidden);
  await tab.change(() => tab.set("#tolerance", "0"));
  expect("the newer question is answered", /^\d+$/.test(await tab.number()));
  await tab.close();
}

async function aLimitGivesProvedBounds({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.gradation(fileOf("long.csv", longGradation()));
  await tab.set("#timeLimit", "2");
  await tab.set("#toleranceKind", "total");
  await tab.change(() => tab.set("#tolerance", "0.5"));
  await tab.until("the bounds", () => / to /.test(document.querySelector("#number").textContent));
  await tab.settled();
  expect("their proof is accepted", (await tab.text("#verdict")).includes("Proof accepted"));
  await tab.close();
}

async function aHundredThousandClassesAreShown({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.gradation(fileOf("many.csv", manyClasses(100_000)));
  expect("accepted", (await tab.text("#verdict")).includes("Proof accepted"));
  const shown = await tab.page.evaluate(() => document.querySelectorAll("#classes tbody tr").length);
  expect(`${shown} rows at first`, shown < 100);
  await tab.click("#classes .more button");
  await tab.until("more rows", (before) => document.querySelectorAll("#classes tbody tr").length > before, shown);
  expect("the curve is thinned", (await tab.page.$eval("#curve svg", (one) => one.outerHTML.length)) < 200_000);
  await tab.close();
}

async function aLongFileIsRefusedOrRead({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  const row = "0".repeat(1022) + "\n";
  await tab.gradation(fileOf("long.csv", "size_mm,mass\n" + row.repeat(64 * 1024)));
  expect("a message", (await tab.text("#message pre")).includes("long.csv:2"));
  expect("its beginning is shown", (await tab.page.$eval("#table", (one) => one.value.length)) < 10_000);
  await tab.change(() => tab.click('#examples [data-name="hostun-rf-sand.csv"]'));
  expect("the page goes on", (await tab.number()) === "31");
  await tab.close();
}

export const onPage = [
  aSearchIsStopped, anOutdatedSearchEnds, aLimitGivesProvedBounds, aHundredThousandClassesAreShown, aLongFileIsRefusedOrRead,
];
