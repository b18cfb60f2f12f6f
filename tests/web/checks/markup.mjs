// Names and ids with markup in them are text: on the page, in the report and in the picture.

import { readFileSync } from "node:fs";

import { Tab, fileOf } from "../support.mjs";

const MARKUP = '<img src=x onerror="window.hurt=1"><b>sand<b>';

async function markupStaysText({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.page.evaluate(() => {
    window.print = () => (window.printed = true);
  });
  const gradation = JSON.stringify({ id: `"><script>window.hurt=1</script>${MARKUP}`, sizes: ["1", "2", "3"], masses: ["2", "1", "0"] });
  await tab.gradation(fileOf(`${MARKUP}.json`, gradation));
  await tab.click("#print");
  await tab.until("the report", () => window.printed);
  const found = await tab.page.evaluate(() => ({
    hurt: window.hurt,
    elements: document.querySelectorAll("main img, main b, main script, .report img, .report b, .report script").length,
    report: document.querySelector("#report").textContent,
    label: document.querySelector("#curve svg").getAttribute("aria-label"),
  }));
  expect("nothing ran", found.hurt === undefined);
  expect("no element was made", found.elements === 0);
  expect("the report shows the id", found.report.includes("<script>window.hurt=1</script>"));
  expect("the picture's label shows the id", found.label.includes(MARKUP));
  expect("the name is shown", (await tab.text("#file-name")).includes("<b>sand<b>"));

  await tab.gradation(fileOf("plain.json", gradation));
  const svg = readFileSync(await tab.download('[data-download="svg"]', "plain.svg"), "utf8");
  expect("the SVG file has the id as text", svg.includes("&lt;script&gt;window.hurt=1") && !svg.includes("<script"));

  await tab.gradation(fileOf("bad.csv", `size_mm,mass\n1,${MARKUP}\n2,0\n`));
  expect("a message shows it", (await tab.text("#message pre")).includes("<img src=x"));
  const after = await tab.page.evaluate(() => [typeof window.hurt, document.querySelectorAll("main img").length]);
  expect("a message runs nothing", after[0] === "undefined" && after[1] === 0);
  await tab.close();
}

export const onPage = [markupStaysText];
