// A link holds the whole question.

import { Tab, fileOf } from "../support.mjs";

async function aLinkHoldsTheQuestion({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.gradation(fileOf("löß & co.csv", "size_mm,mass\n1,20\n2,11\n3,7\n4,0\n"));
  await tab.change(() => tab.set("#tolerance", "0.25"));
  await tab.change(() => tab.set("#minimum", "2"));
  await tab.click("#copy-link");
  await tab.until("the link", () => document.querySelector("#download-note input") !== null);
  const link = await tab.page.$eval("#download-note input", (one) => one.value);
  const seen = [await tab.number(), await tab.text("#asked"), await tab.text("#verdict"), await tab.text("#file-name")];
  await tab.close();

  const other = await Tab.open(open, link);
  const again = [await other.number(), await other.text("#asked"), await other.text("#verdict"), await other.text("#file-name")];
  expect(`${seen} and ${again}`, JSON.stringify(seen) === JSON.stringify(again));
  expect("the question is not the plain one", seen[1].includes("0.25") && seen[1].includes("2 particles"));
  await other.close();
}

async function aBrokenLinkIsSaid({ expect, open, url }) {
  const tab = await Tab.open(open, url + "#q=abc");
  expect("it is said", (await tab.text("#link-note")).includes("cannot be read"));
  expect("the page goes on", (await tab.number()) === "1485");
  await tab.close();
}

export const onPage = [aLinkHoldsTheQuestion, aBrokenLinkIsSaid];
