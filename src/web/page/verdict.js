// The verdict of a proof: each checker runs in a worker of its own and says what it finds.

import { fill, make } from "./dom.js";
import { text } from "./texts.js";

/** What the exit codes mean; those above are as the last. */
const OUTCOMES = ["accepted", "rejected", "malformed"];

async function judgedBy({ name, program }, files, words) {
  const { code, out, err } = await program.run(words, files);
  return { name, code: Math.min(code, 2), line: `${out.trim()}\n${err.trim()}`.trim() };
}

/**
 * Lets all checkers, {name, program}, judge by their command line `words`, which names `files`. One that refuses it decides; one that cannot judge it, as where
 * it is too long for it, decides only where no other can, and else is a reservation.
 */
export async function judgeFiles(checkers, files, words) {
  const results = await Promise.all(checkers.map((checker) => judgedBy(checker, files, words)));
  const code = [1, 0, 2].find((one) => results.some((result) => result.code === one));
  const deciding = results.filter((result) => result.code === code);
  return {
    outcome: OUTCOMES[code],
    line: deciding[0].line,
    checkers: deciding.map(({ name }) => name),
    reservations: results.filter((result) => result.code === 2 && code !== 2),
  };
}

/** Lets all checkers judge the proof of a gradation's answer. */
export function judge(checkers, gradation, proof) {
  const files = { [gradation.name]: gradation.blob, [proof.name]: proof.blob };
  return judgeFiles(checkers, files, [gradation.name, proof.name]);
}

const nameInWords = (name) => (name === "verified" ? text("verified-checker") : name);

/** The names of the checkers in a sentence. */
export function checkersInWords(names) {
  return text("verdict.by", { checkers: names.map(nameInWords).join(text("verdict.and")) });
}

/** Shows a verdict: a sign, a word, the checker's own line, and `read`, an element that says what it is about. */
export function showVerdict(place, verdict, read) {
  place.className = `verdict ${verdict.outcome}`;
  const sign = make("span", { class: "sign", "aria-hidden": "true" }, verdict.outcome === "accepted" ? "✓" : "✗");
  const by = verdict.outcome === "malformed" ? "" : ", " + checkersInWords(verdict.checkers);
  const reservations = verdict.reservations.map(({ name, line }) =>
    make("p", { class: "verdict-line" }, `${text("verdict.reservation", { checker: nameInWords(name) })} `,
      make("span", { lang: "en" }, line)),
  );
  fill(
    place,
    make("p", { class: "verdict-head" }, sign, make("strong", {}, text(`verdict.${verdict.outcome}`)), by),
    make("p", { class: "verdict-line", lang: "en" }, verdict.line),
    ...reservations,
    read,
  );
}
