// node by_node.mjs MODULE PROGRAM WORDS...: runs mdm or mdm-check of the JavaScript module in the folder MODULE as the command line
// does: with standard input, with the files that its words name (and their indexes), at their paths, and those that it writes.

import { existsSync, readFileSync, statSync, writeFileSync, writeSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [module, program, ...words] = process.argv.slice(2);
const { default: createProgram } = await import(pathToFileURL(resolve(module, `${program}.js`)));

/** The files that are shown to the program, by their absolute paths. */
const shown = new Map();
for (const path of words.map((word) => resolve(word)))
  for (const one of [path, `${path}.index`])
    if (existsSync(one) && statSync(one).isFile()) shown.set(one, readFileSync(one));

const input = words.includes("-") ? readFileSync(0) : Buffer.alloc(0);
const printed = { 1: [], 2: [] };
let read = 0;

const instance = await createProgram({
  wasmBinary: readFileSync(resolve(module, `${program}.wasm`)),
  preRun: [
    ({ FS }) => {
      const nextByte = () => (read < input.length ? input[read++] : null);
      FS.init(nextByte, (byte) => printed[1].push(byte), (byte) => printed[2].push(byte));
    },
  ],
});
const { FS } = instance;
for (const folder of words.map((word) => dirname(resolve(word)))) if (existsSync(folder)) FS.mkdirTree(folder);
for (const [path, bytes] of shown) FS.writeFile(path, bytes);
FS.mkdirTree(process.cwd());
FS.chdir(process.cwd());

const code = instance.callMain(words);

/** Writes what is new or changed below a folder of the program's. */
function writeBack(folder) {
  for (const name of FS.readdir(folder).filter((one) => one !== "." && one !== "..")) {
    const path = join(folder, name);
    if (path === "/dev" || path === "/proc") continue;
    if (FS.isDir(FS.stat(path).mode)) writeBack(path);
    else if (!shown.get(path)?.equals(FS.readFile(path))) writeFileSync(path, FS.readFile(path));
  }
}
writeBack("/");
for (const [file, bytes] of Object.entries(printed)) writeSync(Number(file), Buffer.from(bytes));
process.exitCode = code;
