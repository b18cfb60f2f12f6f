// The worker of the verified checker, which js_of_ocaml has made a function of two files.

import { mdmCheckVerified } from "verified-checker";

import { serveProgram } from "./worker.js";

const encoder = new TextEncoder();

serveProgram(async () => ({
  run([gradation, certificate], files) {
    const file = (name) => [encoder.encode(name), files[name]];
    const { code, output, error } = mdmCheckVerified(...file(gradation), ...file(certificate));
    return { code, out: output, err: error, files: {} };
  },
}));
