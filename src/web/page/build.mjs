// Writes exactmdm.html, one file with all that the page needs.
//
//     node page/build.mjs OUT --glue MDM.js --wasm MDM.wasm --check-glue CHECK.js --check-wasm CHECK.wasm
//         [--verified CHECKER.js] [--root FOLDER]

import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";

import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));

/** What Emscripten's code asks for in Node alone. */
const NODE_MODULES = ["fs", "path", "crypto", "worker_threads", "perf_hooks", "url", "module", "node:*"];

/** The minified text of an entry with all that it imports; `alias` says which files some names stand for. */
async function bundle(entry, alias = {}) {
  const { outputFiles } = await build({
    entryPoints: [join(here, entry)],
    alias,
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["es2022"],
    charset: "ascii",
    loader: { ".csv": "text" },
    external: NODE_MODULES,
    // Of code that Emscripten and js_of_ocaml have made.
    logOverride: { "empty-import-meta": "silent", "duplicate-case": "silent" },
  });
  return outputFiles[0].text;
}

async function minifiedStyle() {
  const { outputFiles } = await build({ entryPoints: [join(here, "style.css")], minify: true, write: false });
  return outputFiles[0].text;
}

/** Data in an element that the browser takes for no script: no text of it may end the element. */
function dataElement(id, text) {
  return `<script type="text/plain" id="${id}">${text.replaceAll("<", "\\u003c")}</script>`;
}

const packed = async (path) => gzipSync(await readFile(path), { level: 9 }).toString("base64");

function policyFor(script) {
  const digest = createHash("sha256").update(script).digest("base64");
  return [
    "default-src 'none'",
    `script-src 'sha256-${digest}' 'wasm-unsafe-eval' blob:`,
    "worker-src blob:",
    "style-src 'unsafe-inline'",
    "img-src data: blob:",
    "connect-src 'none'",
    "form-action 'none'",
    "base-uri 'none'",
  ].join("; ");
}

async function page(inputs) {
  const worker = async (id, entry, alias) => dataElement(id, JSON.stringify(await bundle(entry, alias)));
  const data = [
    await worker("mdm-worker", "program_worker.js", { "program-glue": resolve(inputs.glue) }),
    dataElement("mdm-wasm", await packed(inputs.wasm)),
    await worker("mdm-check-worker", "program_worker.js", { "program-glue": resolve(inputs["check-glue"]) }),
    dataElement("mdm-check-wasm", await packed(inputs["check-wasm"])),
    await worker("reader-worker", "reader_worker.js"),
  ];
  if (inputs.verified) {
    data.push(await worker("verified-worker", "verified_worker.js", { "verified-checker": resolve(inputs.verified) }));
  }
  const root = resolve(inputs.root ?? join(here, "../../.."));
  const folders = {
    examples: join(root, "examples/gradations"),
    "blend-example": join(root, "examples/08-blend"),
    specifications: join(root, "src/judge/specifications"),
    german: join(root, "src/text"),
  };
  const script = (await bundle("main.js", folders)).replaceAll("</script", "<\\/script");
  const { version } = JSON.parse(await readFile(join(here, "../package.json"), "utf8"));
  const parts = { policy: policyFor(script), style: await minifiedStyle(), version, data: data.join("\n"), script };
  const template = await readFile(join(here, "index.html"), "utf8");
  return template.replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]);
}

const text = { type: "string" };
const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { glue: text, wasm: text, "check-glue": text, "check-wasm": text, verified: text, root: text },
});
await writeFile(positionals[0], await page(values));
