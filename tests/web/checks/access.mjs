// The page for everybody: axe-core has no findings, the keyboard is enough, a phone's width is enough.

import { Tab, axeSource } from "../support.mjs";

async function axeFindsNothing({ expect, open, url }) {
  for (const scheme of ["light", "dark"]) {
    for (const language of ["en", "de"]) {
      const tab = await Tab.open(open, url, {
        onPage: (page) => (open.name === "chromium"
          ? page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }])
          : undefined),
      });
      await tab.click(`[data-language="${language}"]`);
      await tab.set("#specimen", "cylinder");
      for (const details of ["#reading", "#soil"]) await tab.page.$eval(details, (one) => (one.open = true));
      await tab.click("#tradeoff-run");
      await tab.until("the trade-off", () => document.querySelector("#tradeoff-result table") !== null);
      await tab.page.evaluate(axeSource);
      const scan = async () => {
        const findings = await tab.page.evaluate(async () => {
          const { violations } = await window.axe.run(document);
          return violations.map(({ id, nodes }) => `${id}: ${nodes.map((one) => one.html).join(" | ")}`);
        });
        expect(`${scheme}, ${language}: ${findings.join("\n")}`, findings.length === 0);
      };
      await scan();
      await tab.change(() => tab.set("#table", "2\t100\n1\t40\n0.5\t0\n"));
      expect("it is asked what the columns are", (await tab.page.$(".asking")) !== null);
      await scan();
      await tab.close();
    }
  }
}

/** Presses Tab until an element has the focus. */
async function tabTo(tab, selector) {
  for (let presses = 0; presses < 80; presses++) {
    await tab.page.keyboard.press("Tab");
    if (await tab.page.evaluate((one) => document.activeElement?.matches(one) ?? false, selector)) return;
  }
  throw new Error(`no way to ${selector} by the keyboard`);
}

async function theKeyboardIsEnough({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tabTo(tab, '[data-language="de"]');
  await tab.page.keyboard.press("Enter");
  expect("German", (await tab.text("#answer-title")) === "Ergebnis");
  await tabTo(tab, "#gradation-file");
  const outline = await tab.page.$eval('label[for="gradation-file"]', (one) => getComputedStyle(one).outlineStyle);
  expect("the focus of the file's button is seen", outline === "solid");
  await tabTo(tab, '[data-name="hostun-rf-sand.csv"]');
  await tab.change(() => tab.page.keyboard.press("Enter"));
  expect("the example's number", (await tab.number()) === "31");
  await tabTo(tab, "#minimum-slider");
  await tab.page.keyboard.press("ArrowRight");
  await tab.until("an effect", () => document.querySelector("#number").textContent !== "31");
  await tabTo(tab, '[data-download="json"]');
  await tabTo(tab, "#tradeoff-run");
  await tab.page.keyboard.press("Enter");
  await tab.until("the trade-off", () => document.querySelector("#tradeoff-result table") !== null);
  await tabTo(tab, "#proof-check");
  await tab.close();
}

async function aPhonesWidthIsEnough({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  await tab.page.setViewport({ width: 360, height: 740 });
  await tab.click("#tradeoff-run");
  await tab.until("the trade-off", () => document.querySelector("#tradeoff-result table") !== null);
  const width = await tab.page.evaluate(() => document.documentElement.scrollWidth);
  expect(`${width} pixels`, width <= 360);
  await tab.close();
}

async function theNumberIsAnnounced({ expect, open, url }) {
  const tab = await Tab.open(open, url);
  const live = await tab.page.$eval("#announcement", (one) => [one.getAttribute("aria-live"), one.textContent]);
  expect(`live: ${live}`, live[0] === "polite" && live[1].includes("Proof accepted"));
  await tab.close();
}

export const onPage = [axeFindsNothing, theKeyboardIsEnough, aPhonesWidthIsEnough, theNumberIsAnnounced];
