// What is asked of mdm report and of mdm convert, as the words of the command line.

import { withPoint } from "../numbers.js";

const option = (name, value) => (value.trim() ? [`--${name}=${value.trim()}`] : []);

/**
 * The words of mdm report: samples {name}, `specification`, a name that the program knows or that of a file, or "",
 * the head's client, title and fields, a line each, the limits of the fines, and the language.
 */
export function reportWords({ samples, specification, title, client, fields, liquid, plastic, language }, output) {
  const lines = fields.split("\n").filter((line) => line.trim());
  return [
    "report",
    ...samples.map(({ name }) => name),
    ...option("spec", specification),
    ...option("title", title),
    ...option("client", client),
    ...lines.flatMap((line) => option("field", line)),
    ...option("liquid-limit", withPoint(liquid)),
    ...option("plastic-limit", withPoint(plastic)),
    ...(output.endsWith(".json") ? [] : option("language", language)),
    "--quiet", "-o", output,
  ];
}

/** The words of mdm convert that join two analyses of one sample at a sieve of both. */
export const joinWords = ({ coarse, fine, at }, output) => [
  "convert", "--join", coarse, fine, `--at=${withPoint(at)}`, "--quiet", "-o", output,
];
