// The page's tests: node tests/web/page_test.mjs EXACTMDM.html MDM MDM-CHECK chromium|firefox
// One line for each check that fails; exit code 1 if one does.

import { readdirSync } from "node:fs";
import { resolve } from "node:path";

import { launch, removeFolders, urlOf } from "./support.mjs";

const [page, mdm, mdmCheck] = process.argv.slice(2, 5).map((path) => resolve(path));
const browser = process.argv[5];
let failures = 0;

/** What is found wrong by work, which is given the function that expects. */
async function findings(work) {
  const found = [];
  try {
    await work((what, condition) => condition || found.push(what));
  } catch (error) {
    found.push(error.stack);
  }
  return found;
}

function report(name, found) {
  failures += found.length;
  for (const what of found) console.log(`${name}: ${what}`);
}

const files = readdirSync(new URL("checks/", import.meta.url)).sort();
const groups = await Promise.all(files.map((file) => import(`./checks/${file}`)));

for (const job of groups.flatMap(({ alone = [] }) => alone)) report(job.name, await findings(job));
let open = await launch(browser);
const find = (job) => findings((expect) => job({ expect, open, url: urlOf(page), page, mdm, mdmCheck }));
for (const job of groups.flatMap(({ onPage = [] }) => onPage)) {
  let found = await find(job);
  if (found.length > 0) {
    // A browser may fail on a busy machine; the page has to fail in a fresh one, too.
    console.log(`once more, ${browser}, ${job.name}: ${found[0]}`);
    await open.browser.close();
    open = await launch(browser);
    found = await find(job);
  }
  report(`${browser}, ${job.name}`, found);
}
await open.browser.close();
removeFolders();
process.exit(failures > 0 ? 1 : 0);
