// The worker of mdm, and the one of mdm-check: the build says which program's code "program-glue" is.

import glue from "program-glue";

import { loadProgram } from "../module/program.js";
import { serveProgram, unpacked } from "./worker.js";

serveProgram(async ({ wasm }) => loadProgram({ glue, wasm: await unpacked(wasm) }));
