import { readFile } from "node:fs/promises";

/** The bytes of a file beside this one. */
export const bytesOf = (name) => readFile(new URL(name, import.meta.url));
