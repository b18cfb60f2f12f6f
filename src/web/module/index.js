// The smallest sets of particles that match sieve analyses, exactly, with proofs.

import createMdm from "./mdm.js";
import createMdmCheck from "./mdm-check.js";
import { bytesOf } from "#bytes";
import { loadProgram } from "./program.js";

/** What the program says of an input that it cannot take: its message names file, line, value and remedy. */
export class InputError extends Error {
  name = "InputError";
}

const exit = { done: 0, negative: 1, badInput: 2, limit: 3 };
const programs = new Map();

function programOf(name, glue) {
  if (!programs.has(name)) programs.set(name, bytesOf(`${name}.wasm`).then((wasm) => loadProgram({ glue, wasm })));
  return programs.get(name);
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** Text, bytes or a JSON object as bytes. */
function bytes(content) {
  if (content instanceof Uint8Array) return content;
  return encoder.encode(typeof content === "string" ? content : JSON.stringify(content));
}

/** The file's name: formats of gradations are told apart by what is in the file, and by its name's ending. */
function fileName(content, name, stem) {
  if (name !== undefined) {
    if (!/^[^/]+$/.test(name) || /^\.\.?$/.test(name)) throw new InputError(`${name}: give a name without folders`);
    return name.startsWith("-") ? `./${name}` : name;
  }
  const text = typeof content === "string" ? content : content instanceof Uint8Array ? "" : "{";
  return stem + (text.trimStart().startsWith("{") ? ".json" : ".csv");
}

/** The options of a command as its words: minPerClass: 2 is --min-per-class 2, verbose: true is --verbose. */
function words(options) {
  return Object.entries(options).flatMap(([key, value]) => {
    const flag = `--${key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
    if (value === undefined || value === false) return [];
    if (value === true) return [flag];
    return [value].flat().map((one) => `${flag}=${one}`);
  });
}

const bandName = "band.csv";

/** The same with an envelope, which is given as its content: the words, and the files that they name. */
function asked({ band, ...options }) {
  if (band === undefined) return { words: words(options), files: {} };
  return { words: words({ ...options, band: bandName }), files: { [bandName]: band } };
}

/** Files by name, each with its bytes. */
const inBytes = (files) => Object.fromEntries(Object.entries(files).map(([name, content]) => [name, bytes(content)]));

/** Runs a program as on the command line. */
export async function run(commandLine, files = {}, onProgress = undefined) {
  return (await programOf("mdm", createMdm)).run(commandLine, inBytes(files), onProgress);
}

/** The same for a function of this module: messages name its options as its callers write them, `minPerClass`. */
async function runCommand(commandLine, files, onProgress = undefined) {
  const environment = { MDM_OPTION_SPELLING: "member" };
  return (await programOf("mdm", createMdm)).run(commandLine, inBytes(files), onProgress, environment);
}

/** The same for mdm-check. */
export async function runCheck(commandLine, files = {}) {
  return (await programOf("mdm-check", createMdmCheck)).run(commandLine, inBytes(files));
}

/** What a run printed, unless it refused its input. */
function printed(result) {
  if (result.code === exit.badInput) throw new InputError(result.err.trim());
  return result.out;
}

const proofName = "proof.mdm";

export async function solve(gradation, { name, proof = false, onProgress, ...options } = {}) {
  const file = fileName(gradation, name, "gradation");
  const { words, files } = asked(options);
  const commandLine = ["solve", ...words, "--format=json", "--quiet", file];
  if (proof) commandLine.splice(1, 0, `--proof=${proofName}`);
  const result = await runCommand(commandLine, { ...files, [file]: gradation }, onProgress);
  const answer = JSON.parse(printed(result));
  const written = result.files[proofName];
  return { answer, proof: written ? decoder.decode(written) : null };
}

export async function check(gradation, proof, { name } = {}) {
  const file = fileName(gradation, name, "gradation");
  const { code, out, err } = await runCheck([file, proofName], { [file]: gradation, [proofName]: proof });
  return { verdict: ["accepted", "refused", "malformed"][code], line: out.trim(), reason: err.trim() };
}

export async function batch(gradations, options = {}) {
  const lines = gradations.map((gradation) => (typeof gradation === "string" ? gradation : JSON.stringify(gradation)));
  const file = "suite.jsonl";
  const { words, files } = asked(options);
  const content = lines.join("\n") + "\n";
  const result = await runCommand(["batch", ...words, "--quiet", file], { ...files, [file]: content });
  return printed(result).trim().split("\n").map((line) => JSON.parse(line));
}

export async function describe(gradation, { name, ...options } = {}) {
  const file = fileName(gradation, name, "gradation");
  const result = await runCommand(["describe", ...words(options), "--format=json", file], { [file]: gradation });
  return JSON.parse(printed(result));
}

export async function convert(gradation, { name, ...options } = {}) {
  const file = fileName(gradation, name, "gradation");
  return printed(await runCommand(["convert", ...words(options), file], { [file]: gradation }));
}

export async function verify(gradation, sample, { name, sampleName = "sample.txt", ...options } = {}) {
  const file = fileName(gradation, name, "gradation");
  const { words, files } = asked(options);
  const all = { ...files, [file]: gradation, [sampleName]: sample };
  const result = await runCommand(["verify", ...words, "--format=json", file, sampleName], all);
  return JSON.parse(printed(result));
}

/** An object as a line of JSON, whole numbers of any length as strings. */
const inLine = (object) => JSON.stringify(object, (_, value) => (typeof value === "bigint" ? String(value) : value)) + "\n";

/** What a solver says of a gradation, as a line of answers. */
async function answered(gradation, solver, id) {
  let answer;
  try {
    answer = await solver(gradation);
  } catch (error) {
    return inLine({ id, status: "crashed", reason: String(error) });
  }
  if (answer === null || answer === undefined) return inLine({ id, status: "no-answer", reason: "the solver returned nothing" });
  try {
    return inLine({ ...(Array.isArray(answer) ? { quantities: answer.map(String) } : answer), id });
  } catch (error) {
    return inLine({ id, status: "garbage", reason: String(error) });
  }
}

export async function crosscheck(gradations, solver, options = {}) {
  const suite = gradations.map((given) => (typeof given === "string" ? given.trim() : JSON.stringify(given)));
  const ids = suite.map((line, i) => String(JSON.parse(line).id ?? i + 1));
  if (new Set(ids).size < ids.length) throw new InputError("gradations: two have one id: give each its own");
  let answers = "";
  for (const [i, line] of suite.entries()) answers += await answered(JSON.parse(line), solver, ids[i]);
  const { words, files } = asked(options);
  const all = { ...files, "suite.jsonl": suite.join("\n") + "\n", "answers.jsonl": answers };
  const commandLine = ["crosscheck", ...words, "--format=json", "--quiet", "suite.jsonl", "answers.jsonl"];
  return JSON.parse(printed(await runCommand(commandLine, all)));
}

export async function tradeoff(gradation, { name, onProgress, ...options } = {}) {
  const file = fileName(gradation, name, "gradation");
  const { words, files } = asked(options);
  const commandLine = ["tradeoff", ...words, "--format=json", file];
  return JSON.parse(printed(await runCommand(commandLine, { ...files, [file]: gradation }, onProgress)));
}

/** Texts `NAME=VALUE` of an object. */
const ofEach = (values) =>
  values && Object.getPrototypeOf(values) === Object.prototype
    ? Object.entries(values).map(([name, value]) => `${name}=${value}`)
    : values;

/** The name of a specification that comes with mdm; all others have several lines. */
const isName = (specification) => typeof specification === "string" && /^[\w.-]+$/.test(specification);

/** Gradations by their names as files, `names`, to which `put` adds others under names that are free. */
function filesOf(gradations) {
  const files = {};
  const put = (name, content) => {
    files[name] = content;
    return name;
  };
  const names = Object.entries(gradations).map(([name, content]) =>
    put(fileName(content, undefined, fileName("", name, "")), content),
  );
  /** The name of a file beside them, which may have any. */
  const free = (name) => (name in files ? free(`other-${name}`) : name);
  return { files, names, free, put: (name, content) => put(free(name), content) };
}

export async function judge(samples, specification, options = {}) {
  const { files, names, put } = filesOf(samples);
  const limits = isName(specification) ? specification : put("specification.csv", specification);
  const commandLine = ["judge", ...words(options), `--spec=${limits}`, "--format=json", "--quiet", ...names];
  return JSON.parse(printed(await runCommand(commandLine, files)));
}

export async function blend(stockpiles, specification, { target, proof = false, cost, share, ...options } = {}) {
  const { files, names, free, put } = filesOf(stockpiles);
  const limits = put("specification.csv", specification);
  const commandLine = [...words({ ...options, cost: ofEach(cost), share: ofEach(share) }), `--spec=${limits}`];
  if (/^(power45|fuller|andreasen|bolomey):[^\n]*$/.test(target)) commandLine.push(`--target=${target}`);
  else if (target !== undefined) commandLine.push(`--target=${put(fileName(target, undefined, "target"), target)}`);
  const blendedName = free("blended.csv");
  if (proof) commandLine.push(`--proof=${proofName}`);
  const result = await runCommand(
    ["blend", ...commandLine, `--blended=${blendedName}`, "--format=json", "--quiet", ...names],
    files,
  );
  const answer = JSON.parse(printed(result));
  const written = (name) => (result.files[name] ? decoder.decode(result.files[name]) : null);
  return { answer, blended: written(blendedName), proof: written(proofName) };
}
