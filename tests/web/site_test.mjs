// node tests/web/site_test.mjs SITE: no page of the site in the folder SITE is wider than a phone, and its search finds
// what there is. The pages of doxygen are its own.

import { readdirSync } from "node:fs";
import { join } from "node:path";

import { launch, removeFolders, urlOf } from "./support.mjs";

const PHONE = { width: 390, height: 844, deviceScaleFactor: 3, isMobile: true, hasTouch: true };
const site = process.argv[2];
const pages = readdirSync(site, { recursive: true })
  .filter((name) => name.endsWith(".html") && !/^(library|_downloads)\/|^exactmdm\.html$/.test(name));

let failures = 0;
const { browser } = await launch("chromium");
const tab = await browser.newPage();
await tab.setViewport(PHONE);
for (const page of pages) {
  await tab.goto(urlOf(join(site, page)));
  const width = await tab.evaluate(() => document.documentElement.scrollWidth);
  if (width > PHONE.width) {
    console.log(`${page} is ${width} px wide on a phone of ${PHONE.width} px`);
    failures += 1;
  }
}

await tab.goto(`${urlOf(join(site, "search.html"))}?q=tolerance`);
await tab.waitForFunction(() =>
  [...document.querySelectorAll("#search-results li a")].some((link) => link.textContent === "mdm solve"));

await browser.close();
removeFolders();
console.log(`${pages.length} pages, ${failures} failures`);
process.exit(pages.length > 0 && failures === 0 ? 0 : 1);
