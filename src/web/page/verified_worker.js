// The worker of the verified checker, which js_of_ocaml has made a function of files.

import { mdmCheckVerified } from "verified-checker";

import { serveProgram } from "./worker.js";

const encoder = new TextEncoder();

serveProgram(async () => ({
  run(names, files) {
    const { code, output, error } = mdmCheckVerified(...names.flatMap((name) => [encoder.encode(name), files[name]]));
    return { code, out: output, err: error, files: {} };
  },
}));
