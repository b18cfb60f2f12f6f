// From the question to the checked answer.

import { reader, solver } from "./workers.js";
import { stem } from "./files.js";
import { readingFlags, solveFlags } from "./question.js";

/** The names of what solve writes for a gradation; none is the gradation's own. */
export function namesFor(gradation) {
  const base = stem(gradation);
  return { answer: `${base}.answer.json`, reading: `${base}.reading.json`, proof: base === gradation ? `${base}.certificate` : `${base}.proof` };
}

/** What a program reads of a file: its command line, and where it says so. */
export const readingCommand = (name, flags, output) => ["convert", name, ...flags, "--dry-run", "--format", "json", "-o", output];

/** What is read of the gradation, asked of the program that solves. */
async function readingOf(gradation, options, output) {
  const argv = readingCommand(gradation.name, readingFlags(options), output);
  const { files, err } = await solver.run(argv, { [gradation.name]: gradation.blob });
  if (files[output] === undefined) throw new Error(err);
  return { name: gradation.name, ...(await reader.ask({ operation: "reading", blob: files[output] })) };
}

/**
 * Solves the question {gradation, options}. Gives {code, message, answer, ...}: `answer` is null where there is none;
 * then `message` says why. Fails with Stopped.
 */
export async function solve({ gradation, options }, onProgress) {
  const names = namesFor(gradation.name);
  const flags = solveFlags(options);
  const argv = ["solve", gradation.name, ...flags, "--format", "json", "-o", names.answer, "--proof", names.proof];
  const { code, err, files } = await solver.run(argv, { [gradation.name]: gradation.blob }, onProgress);
  const blob = files[names.answer];
  if (blob === undefined) return { code, message: err, answer: null };

  const canonicalName = `${names.proof}.gradation.csv`;
  const canonical = files[canonicalName];
  return {
    code,
    message: err,
    flags,
    gradation,
    answer: await reader.ask({ operation: "answer", blob }),
    reading: await readingOf(gradation, options, names.reading),
    answerFile: { name: names.answer, blob },
    proof: files[names.proof] ? { name: names.proof, blob: files[names.proof] } : null,
    /** What the proof is about: the gradation, or the canonical one that was made of it. */
    checked: canonical ? { name: canonicalName, blob: canonical } : gradation,
  };
}
