// module_test.mjs MODULE MDM MDM-CHECK SOURCE CERTIFICATES: the JavaScript module in Node says what the native programs say.

import assert from "node:assert";
import { spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const [folder, mdm, mdmCheck, source, certificates] = process.argv.slice(2).map((name) => resolve(name));
const { InputError, batch, blend, check, convert, crosscheck, describe, judge, run, runCheck, solve, tradeoff, verify } = await import(
  pathToFileURL(join(folder, "index.js"))
);

const gradations = join(source, "examples/gradations");
const sand = readFileSync(join(gradations, "ottawa-f65-sand.csv"), "utf8");

function native(program, words, cwd) {
  const { status, stdout, stderr } = spawnSync(program, words, { cwd, encoding: "utf8", maxBuffer: 1 << 30 });
  return { code: status, out: stdout, err: stderr };
}

/** An answer without the versions of the libraries, which are others. */
const withoutVersions = ({ versions, ...rest }) => rest;

test("the suite of 2,750 gradations has the native answers", async () => {
  const suite = join(source, "examples/reference/average/suite-2750.jsonl");
  const lines = readFileSync(suite, "utf8").trim().split("\n");
  const answers = await batch(lines);
  const expected = native(mdm, ["batch", suite, "--quiet"]).out.trim().split("\n").map((line) => JSON.parse(line));
  assert.strictEqual(answers.length, 2750);
  answers.forEach((answer, i) => assert.deepStrictEqual(withoutVersions(answer), withoutVersions(expected[i]), lines[i]));
});

test("answers within a tolerance, of bands, solids and laws are the native ones", async () => {
  for (const file of readdirSync(gradations).filter((name) => name.endsWith(".csv") && !name.includes("limits")))
    for (const words of [
      [],
      ["--tolerance", "retained:1%"],
      ["--tolerance", "passing:0.5%", "--min-per-class", "2"],
      ["--specimen", "cylinder:50x100", "--void-ratio", "0.6"],
      ["--law", "power:5/2"],
      ["--digits", "40"],
      ["--cut-below", "0.2mm"],
    ]) {
      const bytes = readFileSync(join(gradations, file));
      const ours = await run(["solve", file, "--quiet", ...words], { [file]: bytes });
      assert.deepStrictEqual(
        { code: ours.code, out: ours.out, err: ours.err },
        native(mdm, ["solve", file, "--quiet", ...words], gradations),
        `${file} ${words}`,
      );
    }
});

test("a solver's answers are judged, whatever becomes of them", async () => {
  const gradation = { sizes: ["1", "2", "3"], masses: ["2", "1", "0"] };
  const solvers = {
    minimal: () => ({ quantities: [3n, 1n] }),
    larger: async () => ({ quantities: ["6", "2"] }),
    "not-a-match": () => [1, 1],
    "no-answer": () => null,
    "gave-up": () => ({ status: "gave up" }),
    garbage: () => { const round = {}; round.round = round; return round; },
    crashed: () => { throw new Error("lost"); },
  };
  for (const [verdict, solver] of Object.entries(solvers)) {
    const judged = await crosscheck([gradation, { ...gradation, id: "b" }], solver);
    assert.deepStrictEqual(judged.rows.map((row) => [row.id, row.verdict]), [["1", verdict], ["b", verdict]]);
  }
  const tolerant = await crosscheck([gradation], () => [1, 1], { tolerance: "retained:20%" });
  assert.strictEqual(tolerant.rows[0].verdict, "minimal");
  await assert.rejects(crosscheck([{ ...gradation, id: "a" }, { ...gradation, id: "a" }], () => null), InputError);
});

test("a batch for several threads is answered by the one that there is", async () => {
  const lines = '{"id":"a","unit":"mm","sizes":[1,2],"masses":[1,0]}\n'.repeat(3);
  const words = ["batch", "lines.jsonl", "--format", "csv", "--quiet"];
  const [one, many] = await Promise.all([[], ["-j", "4"]].map((more) => run([...words, ...more], { "lines.jsonl": lines })));
  assert.strictEqual(many.code, 0);
  assert.deepStrictEqual(many, one);
});

test("all pairs of certificates have the native verdict and message", async () => {
  let compared = 0;
  for (const kind of ["accepted", "rejected", "unparsable"]) {
    const cwd = join(certificates, kind);
    const files = readdirSync(cwd);
    for (const proof of files.filter((name) => name.endsWith(".proof"))) {
      const stem = proof.slice(0, -".proof".length);
      const gradation = files.find((name) => name === `${stem}.csv` || name === `${stem}.json`);
      const inputs = Object.fromEntries([gradation, proof].map((name) => [name, readFileSync(join(cwd, name))]));
      const { code, out, err } = await runCheck([gradation, proof], inputs);
      assert.deepStrictEqual({ code, out, err }, native(mdmCheck, [gradation, proof], cwd), proof);
      ++compared;
    }
  }
  assert.ok(compared > 300, `${compared} pairs`);
});

test("files of laboratories are read as by the native program", async () => {
  const formats = join(gradations, "formats");
  for (const name of readdirSync(formats).filter((file) => file !== "README.md")) {
    const ours = await run(["describe", name], { [name]: readFileSync(join(formats, name)) });
    assert.deepStrictEqual({ code: ours.code, out: ours.out, err: ours.err }, native(mdm, ["describe", name], formats), name);
  }
});

test("a proof is accepted by both checkers, and a changed one refused", async () => {
  const { answer, proof } = await solve(sand, { tolerance: "retained:1%", proof: true });
  assert.strictEqual(answer.status, "optimal");
  assert.strictEqual(typeof answer.particles, "string");
  assert.strictEqual((await check(sand, proof)).verdict, "accepted");
  const changed = proof.replace(/^particles (\d+)$/m, (_, n) => `particles ${BigInt(n) - 1n}`);
  assert.notStrictEqual(changed, proof);
  const refused = await check(sand, changed);
  assert.strictEqual(refused.verdict, "refused");
  assert.notStrictEqual(refused.reason, "");
  assert.strictEqual((await check(sand, "no proof")).verdict, "malformed");
});

test("a gradation may be an object, and an option a flag or a list", async () => {
  const object = { sizes: ["1", "2", "4"], masses: ["1", "3", "0"], unit: "mm" };
  const { answer } = await solve(object, { minPerClass: 2, digits: 5, verbose: false });
  assert.ok(answer.classes.every((one) => BigInt(one.quantity) >= 2n));
  const [first, second] = await batch([object, JSON.stringify(object)]);
  assert.strictEqual(first.particles, second.particles);
});

test("the example of the README runs", async () => {
  const readme = readFileSync(join(source, "src/web/README.md"), "utf8");
  const code = readme.match(/^    import .*from "exactmdm";\n(?:    .*\n|\n)+/m)[0].replace('"exactmdm"', JSON.stringify(join(folder, "index.js")));
  const { status, stdout, stderr } = spawnSync(process.execPath, ["--input-type=module", "-e", code], { encoding: "utf8" });
  assert.strictEqual(status, 0, stderr);
  assert.match(stdout, /^\d+ \[.*\]\naccepted\n$/);
});

test("the other commands give their reports", async () => {
  assert.match((await describe(sand)).schema, /^mdm-describe/);
  assert.match(await convert(sand), /^size_mm,mass\n/);
  assert.match((await tradeoff(sand, { tolerances: "1,2" })).schema, /^mdm-tradeoff/);
  const { answer } = await solve(sand);
  const report = await verify(sand, JSON.stringify(answer), { sampleName: "answer.json" });
  assert.match(report.schema, /^mdm-verify/);
});

test("verdicts on samples are those of the native program", async () => {
  const report = "size_mm,passing_percent\n9.5,100\n4.75,97\n2.36,85\n1.18,85\n0.6,45\n0.3,20\n0.15,5\n";
  const limits = "size_mm,passing_min_percent,passing_max_percent\n9.5,100,100\n0.6,40,50\n";
  const folder = mkdtempSync(join(tmpdir(), "judged"));
  writeFileSync(join(folder, "one.csv"), report);
  writeFileSync(join(folder, "limits.csv"), limits);
  // Notes name options as the callers write them.
  const bare = ({ samples, versions, ...rest }) => ({ ...rest, samples: samples.map(({ notes, ...sample }) => sample) });
  const asked = ["--limit", "FM=2.3..3.1", "--limit", "retained=..45%", "--format", "json", "--quiet"];
  for (const [specification, given] of [["astm-c33-fine", "astm-c33-fine"], [limits, "limits.csv"]]) {
    const found = await judge({ one: report }, specification, { limit: ["FM=2.3..3.1", "retained=..45%"] });
    const said = JSON.parse(native(mdm, ["judge", "one.csv", "--spec", given, ...asked], folder).out);
    found.specification.id = said.specification.id;
    assert.deepStrictEqual(bare(found), bare(said));
  }
  assert.strictEqual((await judge({ one: report }, "astm-c33-fine")).verdict, "hangs");
  assert.strictEqual((await judge({ one: report }, "astm-c33-fine", { rounding: "none" })).verdict, "pass");
  await checkRefusal(judge({ one: report }, "astm-c33-fine", { limit: "FM" }), ["limit"]);
});

test("a blend is that of the native program, with a proof that the checker accepts", async () => {
  const folder = join(source, "examples/08-blend");
  const content = (name) => readFileSync(join(folder, name), "utf8");
  const stockpiles = Object.fromEntries(["A", "B", "C", "D"].map((name) => [name, content(`${name}.csv`)]));
  const cost = { A: "7", B: "10.82", C: 9.51, D: "8.88" };
  const limits = content("limits.csv");
  const { answer, blended, proof } = await blend(stockpiles, limits, { cost, share: { B: "5.." }, proof: true });
  const files = ["A.csv", "B.csv", "C.csv", "D.csv"];
  const asked = ["--cost", "A=7,B=10.82,C=9.51,D=8.88", "--share", "B=5..", "--format", "json", "--quiet"];
  const said = JSON.parse(native(mdm, ["blend", ...files, "--spec", "limits.csv", ...asked], folder).out);
  assert.deepStrictEqual({ ...withoutVersions(answer), specification: "limits" }, withoutVersions(said));
  assert.match(blended, /^size_mm,mass\n/);
  const named = Object.fromEntries(files.map((name) => [name, content(name)]));
  const { code, out } = await runCheck(["limits.csv", ...files, "a.proof"], { ...named, "limits.csv": limits, "a.proof": proof });
  assert.strictEqual(code, 0, out);
});

test("stockpiles may be called as other files are, and what is no blend has its reason", async () => {
  const object = (...masses) => ({ sizes: ["1", "2", "4"], masses: [...masses, "0"] });
  const limits = "size_mm,passing_min_percent,passing_max_percent\n2,40,60\n4,100,100\n";
  const stockpiles = { specification: object("9", "1"), target: object("1", "9") };
  const target = { sizes: ["1", "2", "4"], masses: ["1", "1", "0"] };
  const { answer } = await blend(stockpiles, limits, { target, minimise: "max-deviation" });
  assert.deepStrictEqual([answer.status, answer.blends[0].shares], ["optimal", ["1/2", "1/2"]]);
  const none = (await blend(stockpiles, limits.replace("40,60", "95,99"))).answer;
  assert.deepStrictEqual([none.status, none.contradiction.limits.length], ["none", 1]);
  await checkRefusal(blend(stockpiles, limits, { atMostStockpiles: "x" }), ["atMostStockpiles"]);
  await assert.rejects(blend({ "../a": object("1", "1") }, limits), InputError);
});

test("what cannot be taken is an InputError with the program's message, and the next call goes on", async () => {
  for (const bad of ["", "size_mm,mass\n1,x\n2,1\n", new Uint8Array([0, 255, 254]), {}, "1,2\n0,0\n"])
    await assert.rejects(solve(bad), InputError);
  await assert.rejects(solve(sand, { name: "../sand.csv" }), InputError);
  await assert.rejects(solve(sand, { toleranse: "1%" }), /toleranse/);
  await assert.rejects(solve("size_mm,mass\n1,x\n2,1\n", { name: "mine.csv" }), /^InputError: mine\.csv:2: /);
  assert.strictEqual((await solve(sand)).answer.particles, "2498");
});

/** The options that a message names as the command line does, but in a command of the program: `see mdm solve --help`. */
const hyphensOf = (message) => message.replace(/mdm [^;:,()]*/g, "").match(/(?<![\w-])--[a-z][a-z-]*/g) ?? [];

function checkSpelling(message, names) {
  assert.deepStrictEqual(hyphensOf(message), [], message);
  for (const name of names) assert.match(message, new RegExp(`(?<![\\w-])${name}\\b`));
}

async function checkRefusal(promise, names) {
  const error = await promise.then(() => assert.fail("no error"), (reason) => reason);
  assert.ok(error instanceof InputError, `${error}`);
  checkSpelling(error.message, names);
}

test("a message names the options of a function as its callers write them", async () => {
  assert.deepStrictEqual(hyphensOf("see mdm solve --help; leave out --law"), ["--law"]);
  const canonical = "size_mm,mass\n1,1\n2,0\n";
  const laboratory = "Sieve size (mm),Retained (g)\n2,0\n1,30\n0.5,20\npan,5\n";
  for (const [content, options, names] of [
    ["a,b\n1,2\n2,3\n", {}, ["columns", "kind", "unit", "skip"]],
    ["Sieve size,Retained (g)\n2,0\n1,30\n", {}, ["unit"]],
    ["Opening (mm),Retained (g)\n4,0\n2,5\n1,9\n0.5,20\n0.25,31\n0.125,40\n", {}, ["kind"]],
    ["size_mm,passing_min_percent,passing_max_percent\n1,0,10\n2,100,100\n", {}, ["band"]],
    ["size_mm,passing_percent\n1,50\n2,99.99\n", {}, ["round"]],
    [canonical, { specimenId: "BH1" }, ["specimenId"]],
    [canonical, { sheet: "1" }, ["sheet"]],
    ['{"sizes": ["1", "2"], "masses": ["1", "0"]}', { loss: "2%" }, ["columns", "kind", "unit", "skip", "loss"]],
    [laboratory, { columns: "1" }, ["columns"]],
    [laboratory, { columns: "1,1" }, ["columns"]],
    [laboratory, { columns: "1,x" }, ["columns"]],
    [laboratory, { kind: "weight" }, ["kind"]],
    [laboratory, { kind: "passing" }, ["kind", "columns"]],
    [laboratory, { unit: "um" }, ["unit"]],
    [laboratory, { unit: "km" }, ["unit"]],
  ])
    for (const read of [solve, describe, convert]) await checkRefusal(read(content, options), names);
  for (const [content, options, names] of [
    ["size_mm,quantity\n0.1,2\n", { sizeUnit: "m" }, ["sizeUnit"]],
    ["0.3\n0.3 1\n", {}, ["from"]],
    ["0.3\n", { timestep: 2 }, ["timestep"]],
  ])
    await checkRefusal(verify(sand, content, options), names);
  await checkRefusal(solve(sand, { solidsVolume: 5, law: "power:2" }), ["law"]);
});

test("a note names options as a function's callers write them, and those of a command line as it has them", async () => {
  const fines = "size_mm,mass\n0,60\n0.075,40\n2,0\n";
  const { notes } = await describe(fines);
  checkSpelling(notes.join("\n"), ["extrapolate", "panSize", "liquidLimit", "plasticLimit"]);
  const { answer } = await solve("size_mm,mass\n1,0.30000000000000004\n2,0\n");
  checkSpelling(answer.notes.join("\n"), ["round"]);
  const { out } = await run(["describe", "fines.csv"], { "fines.csv": fines });
  for (const option of ["--extrapolate", "--pan-size", "--liquid-limit"]) assert.ok(out.includes(option), out);
  const refused = await run(["solve", "a.csv", "--sheet", "1"], { "a.csv": "size_mm,mass\n1,1\n2,0\n" });
  assert.match(refused.err, /^a\.csv:1: --sheet is for workbooks/);
});

test("a long search tells its bounds, and ends at its limit with them", async () => {
  const rows = Array.from({ length: 100 }, (_, j) => `${(1.07 ** j).toFixed(4)},${j < 99 ? 1000 + ((j * 7919) % 613) : 0}`);
  const seen = [];
  const onProgress = (bounds) => seen.push(bounds);
  const { answer } = await solve(`size_mm,mass\n${rows.join("\n")}\n`, { tolerance: "total:0.01%", timeLimit: 3, onProgress });
  assert.ok(["optimal", "feasible"].includes(answer.status), answer.status);
  for (const { least, particles } of seen) {
    assert.match(least, /^\d+$/);
    assert.ok(particles === null || BigInt(particles) >= BigInt(least));
  }
});

test("an envelope is given as its text or its bytes", async () => {
  const gradation = "size_mm,mass\n0.1,20\n0.2,30\n0.4,50\n0.8,0\n";
  const band = "size_mm,passing_min_percent,passing_max_percent\n0.1,0,0\n0.2,10,30\n0.4,40,60\n0.8,100,100\n";
  assert.strictEqual((await solve(gradation)).answer.particles, "6");
  assert.strictEqual((await solve(gradation, { band })).answer.particles, "4");
  assert.strictEqual((await solve(gradation, { band: new TextEncoder().encode(band) })).answer.particles, "4");
});

test("the types take what they should, and no more", () => {
  const project = mkdtempSync(join(tmpdir(), "mdm-types-"));
  mkdirSync(join(project, "node_modules"));
  symlinkSync(folder, join(project, "node_modules/exactmdm"));
  copyFileSync(join(source, "tests/web/types.mts"), join(project, "types.mts"));
  const compiler = join(process.env.MDM_WEB_TOOLS, "node_modules/.bin/tsc");
  const flags = ["--noEmit", "--strict", "--noUncheckedIndexedAccess", "--target", "es2022", "--module", "nodenext"];
  const { status, stdout } = spawnSync(compiler, [...flags, "types.mts"], { cwd: project, encoding: "utf8" });
  rmSync(project, { recursive: true });
  assert.strictEqual(status, 0, stdout);
});
