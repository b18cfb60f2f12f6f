// read_by_module.mjs MODULE [--unit UNIT] FILE...: what the JavaScript module says of the files, as mdm batch does.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, ...words] = process.argv.slice(2);
const { run } = await import(pathToFileURL(join(folder, "index.js")));
const names = words[0] === "--unit" ? words.slice(2) : words;
const files = Object.fromEntries(names.map((name) => [name, readFileSync(name)]));
const { out, err } = await run(["batch", "--quiet", ...words], files);
process.stderr.write(err);
process.stdout.write(out);
