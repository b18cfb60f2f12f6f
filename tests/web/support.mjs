// Opens the page as a user does, in Chromium and Firefox, and runs the native programs to compare with.

import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

/** Where npm has installed what the page's tests need. */
const TOOLS = process.env.MDM_WEB_TOOLS ?? fileURLToPath(new URL("../../src/web/", import.meta.url));
export const ROOT = fileURLToPath(new URL("../../", import.meta.url));

const require = createRequire(join(TOOLS, "package.json"));
const puppeteer = require("puppeteer-core").default;
export const axeSource = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

export const PATIENCE = 120_000;

export const examples = readdirSync(join(ROOT, "examples/gradations"))
  .filter((name) => name.endsWith(".csv") && !name.includes("limits"))
  .map((name) => ({ name, path: join(ROOT, "examples/gradations", name) }));

/** A folder for a check's files; all are removed at the end. */
const folders = [];
export function folder() {
  folders.push(mkdtempSync(join(tmpdir(), "exactmdm-page-")));
  return folders.at(-1);
}
export function removeFolders() {
  folders.forEach((one) => rmSync(one, { recursive: true, force: true }));
}

/** Writes a file into a new folder and gives its path. */
export function fileOf(name, content) {
  const path = join(folder(), name);
  writeFileSync(path, content);
  return path;
}

/** Runs a native program. */
export function run(program, argv, options = {}) {
  const { status, stdout, stderr } = spawnSync(program, argv, { encoding: "utf8", maxBuffer: 1 << 28, ...options });
  return { code: status, out: stdout, err: stderr };
}

const CHROMIUM_FLAGS = [
  "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--lang=en-US",
];

const BROWSERS = {
  chromium: () => ({ executablePath: "/usr/bin/chromium", args: CHROMIUM_FLAGS }),
  firefox: (downloads) => ({
    browser: "firefox",
    executablePath: "/usr/bin/firefox-esr",
    extraPrefsFirefox: {
      "browser.download.folderList": 2,
      "browser.download.dir": downloads,
      "browser.download.useDownloadDir": true,
      "browser.download.always_ask_before_handling_new_types": false,
      "intl.accept_languages": "en-US",
    },
  }),
};

/** A browser with an empty profile; its downloads go to `downloads`. */
export async function launch(name) {
  const downloads = folder();
  const browser = await puppeteer.launch({
    headless: true,
    userDataDir: folder(),
    // Chromium finds files by names that are no ASCII in a locale of UTF-8 alone.
    env: { ...process.env, LC_ALL: "C.UTF-8" },
    protocolTimeout: PATIENCE,
    ...BROWSERS[name](downloads),
  });
  if (name === "chromium") {
    const session = await browser.target().createCDPSession();
    await session.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: downloads });
  }
  return { name, browser, downloads };
}

async function until(what, condition) {
  const end = Date.now() + PATIENCE;
  while (Date.now() < end) {
    const value = await condition();
    if (value) return value;
    await new Promise((resolve) => setTimeout(resolve, 60));
  }
  throw new Error(`never: ${what}`);
}

/** The page in a tab, with what a user sees and does. */
export class Tab {
  /** Opens the page and waits for its first answer. */
  static async open({ browser, downloads }, url, { onPage = async () => {} } = {}) {
    const page = await browser.newPage();
    const tab = new Tab(page, downloads);
    page.on("pageerror", (error) => tab.errors.push(error.message));
    page.on("request", (request) => tab.requests.push(request.url()));
    await onPage(page);
    await page.setViewport({ width: 1280, height: 900 });
    await page.goto(url);
    await tab.settled();
    return tab;
  }

  constructor(page, downloads) {
    this.page = page;
    this.downloads = downloads;
    this.errors = [];
    this.requests = [];
  }

  text(selector) {
    return this.page.evaluate((one) => document.querySelector(one)?.innerText ?? "", selector);
  }

  /** Waits until what is asked is answered and its proof judged, or a message is shown. */
  settled() {
    return until("a settled answer", () =>
      this.page.evaluate(() => {
        const isShown = (selector) => document.querySelector(selector)?.checkVisibility() ?? false;
        if (document.querySelector("#answer").getAttribute("aria-busy") === "true") return false;
        return isShown("#message pre") || isShown("#verdict .verdict-line");
      }),
    );
  }

  until(what, script, ...values) {
    return until(what, () => this.page.evaluate(script, ...values));
  }

  /** The number in large, its digits alone. */
  async number() {
    return (await this.text("#number")).replace(/\s/g, "");
  }

  /** Does something that changes the question, and waits for its answer. */
  async change(action) {
    await this.page.evaluate(() => {
      document.querySelector("#verdict").replaceChildren();
      document.querySelector("#message").replaceChildren();
    });
    await action();
    await this.settled();
  }

  /** Chooses a file in an input. */
  async choose(selector, path) {
    const input = await this.page.$(selector);
    await input.uploadFile(path);
  }

  gradation(path) {
    return this.change(() => this.choose("#gradation-file", path));
  }

  /** Sets a control as a user's typing or moving does. */
  async set(selector, value) {
    await this.page.$eval(
      selector,
      (control, wanted) => {
        control.value = wanted;
        control.dispatchEvent(new Event("input", { bubbles: true }));
      },
      value,
    );
  }

  click(selector) {
    return this.page.$eval(selector, (one) => one.click());
  }

  /** Clicks and gives the path of the file that comes. */
  async download(selector, name) {
    const path = join(this.downloads, name);
    rmSync(path, { force: true });
    await this.click(selector);
    await until(`the file ${name}`, () => existsSync(path) && !existsSync(path + ".part") && readFileSync(path).length > 0);
    return path;
  }

  close() {
    return this.page.close();
  }
}

export const urlOf = (path) => pathToFileURL(path).href;
