// The best blend: mdm blend finds it, or why there is none, and the checkers check the proof.

import { quoted } from "../command_line.js";
import { byId, fill, make } from "../dom.js";
import { endInWords } from "../ends.js";
import { download, freeName } from "../files.js";
import { said, saidLines } from "../said.js";
import { text } from "../texts.js";
import { judgeFiles, showVerdict } from "../verdict.js";
import { blender, checkers, reader } from "../workers.js";
import { blendWords, checkWords, filesOf } from "./question.js";

const REFUSES_PROOF = /^(mdm blend: )?--proof/;

let shown = null;
let question = null;

/** Names of what is written, which are none of the question's. */
function namesOf(asked) {
  const taken = Object.keys(filesOf(asked));
  const free = (name) => {
    taken.push(freeName(name, taken));
    return taken.at(-1);
  };
  return { proof: free("proof.mdm"), blended: free("blended.csv"), answer: free("answer.json"), report: free("report.txt") };
}

/** Runs mdm blend for its answer and its report; the proof is left out where mdm-check could not read the files. */
async function solved(asked, names) {
  const files = filesOf(asked);
  const words = [...blendWords(asked), "--quiet"];
  const run = (more) => blender.run([...words, ...more], files);
  const answer = ["--blended", names.blended, "--format", "json", "-o", names.answer];
  let first = await run(["--proof", names.proof, ...answer]);
  const withoutProof = REFUSES_PROOF.test(first.err.trim()) ? first.err.trim() : null;
  if (withoutProof) first = await run(answer);
  if (!first.files[names.answer]) return { message: first.err.trim() };
  const second = await run(["-o", names.report]);
  return {
    asked, names, withoutProof,
    files: { ...first.files, ...second.files },
    report: await second.files[names.report].text(),
    answer: await reader.ask({ operation: "blend", blob: first.files[names.answer] }),
  };
}

/** The verdict of the checkers on the proof. */
async function checked({ asked, names, files }) {
  if (!files[names.proof]) return null;
  const blobs = { ...filesOf(asked), [names.proof]: files[names.proof] };
  return judgeFiles(checkers, blobs, checkWords(asked, names.proof));
}

function commandOf({ asked, names, files }) {
  const proof = files[names.proof] ? ["--proof", names.proof] : [];
  const blend = ["mdm", ...blendWords(asked), ...proof].map(quoted).join(" ");
  return proof.length > 0 ? `${blend}; ${["mdm-check", ...checkWords(asked, names.proof)].map(quoted).join(" ")}` : blend;
}

function downloads({ asked, names, files }) {
  const all = [
    ["blend.download.proof", names.proof, files[names.proof]],
    ["blend.download.blended", names.blended, files[names.blended]],
    ["blend.download.answer", names.answer, files[names.answer]],
    ["blend.download.limits", asked.limits.name, asked.limits.blob],
  ];
  const buttons = all.filter(([, , blob]) => blob).map(([key, name, blob]) => {
    const button = make("button", { type: "button", "data-blend": key.split(".").at(-1) }, text(key));
    button.addEventListener("click", () => download(name, blob));
    return button;
  });
  return make("p", { class: "buttons" }, ...buttons);
}

function show() {
  const { report, verdict, withoutProof } = shown;
  const place = make("div", { class: "verdict" });
  if (verdict) showVerdict(place, verdict, null);
  else fill(place, make("p", {}, text("verdict.none")), withoutProof && said("p", {}, withoutProof));
  fill(
    byId("blend-result"),
    make("h3", {}, text("blend.result")),
    place,
    make("pre", { class: "blend-report", lang: "en", tabIndex: 0 }, report.trimEnd()),
    downloads(shown),
    make("p", { class: "hint" }, `${text("blend.command")} `, make("code", {}, commandOf(shown))),
  );
}

function showSearch() {
  const stop = make("button", { type: "button", id: "blend-stop" }, text("stop"));
  stop.addEventListener("click", () => blender.stop());
  fill(byId("blend-result"), make("p", { class: "searching", role: "status" },
    make("span", { class: "pulse", "aria-hidden": "true" }), make("span", {}, text("blend.searching")), stop));
}

/** Finds and shows the best blend of a question; gives its shares, or null where there is none. */
export async function findBest(asked) {
  question = asked;
  shown = null;
  showSearch();
  try {
    const found = await solved(asked, namesOf(asked));
    if (question !== asked) return null;
    if (found.message) {
      fill(byId("blend-result"), saidLines("pre", { class: "message" }, found.message));
      return null;
    }
    const verdict = await checked(found);
    if (question !== asked) return null;
    shown = { ...found, verdict };
    show();
    return found.answer.shares;
  } catch (error) {
    if (question === asked) fill(byId("blend-result"), make("p", {}, endInWords(error)));
    return null;
  }
}

/** Takes away what was found for another question, and ends a search for one. */
export function forgetBest() {
  if (question !== null && shown === null) blender.stop();
  question = shown = null;
  fill(byId("blend-result"));
}

export function writeBestTexts() {
  if (shown !== null) show();
}
