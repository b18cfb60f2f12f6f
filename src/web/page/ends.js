// Why work ended without a result, in words.

import { Stopped } from "./programs.js";
import { text } from "./texts.js";

export function endInWords(error) {
  return error instanceof Stopped ? text("stopped.nothing") : text("ended", { message: error.message });
}
