// The workers behind the page: the solver, the same program for pictures and for everything else beside the answer, the
// checkers and the reader. Their sources and the programs are in the page, in elements that are no scripts for the browser.

import { byId } from "./dom.js";
import { Program } from "./programs.js";

const data = (id) => byId(id)?.textContent ?? null;
const script = (id) => JSON.parse(data(id));

/** Solves; what it does can be outdated at any moment. */
export const solver = new Program(script("mdm-worker"), { wasm: data("mdm-wasm") });

/** Draws, so that pictures wait for nothing else. */
export const painter = new Program(script("mdm-worker"), { wasm: data("mdm-wasm") });

/** Describes, converts, exports, verifies and computes trade-offs. */
export const helper = new Program(script("mdm-worker"), { wasm: data("mdm-wasm") });

/** Blends stockpiles, beside everything else. */
export const blender = new Program(script("mdm-worker"), { wasm: data("mdm-wasm") });

/** Writes the laboratory's reports, beside everything else. */
export const reporter = new Program(script("mdm-worker"), { wasm: data("mdm-wasm") });

/** Reads what the programs write. */
export const reader = new Program(script("reader-worker"), {});

/** A function of the reader's that gives a promise of some rows of a table: `classes`, `sample` or `sieves`. */
export const rowsOf = (table) => (from, count) => reader.ask({ operation: "rows", table, from, count });

/** The programs that check proofs; the verified one where the build has it. */
export const checkers = [
  { name: "mdm-check", program: new Program(script("mdm-check-worker"), { wasm: data("mdm-check-wasm") }) },
];
if (data("verified-worker") !== null) {
  checkers.push({ name: "verified", program: new Program(script("verified-worker"), {}) });
}
