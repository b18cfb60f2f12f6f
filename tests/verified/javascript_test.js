// javascript_test.js SCRIPT PROGRAM CERTIFICATES: the verified checker in JavaScript says what the program says, and asks
// of its surroundings nothing that a web page would have to allow.

const { test } = require("node:test");
const assert = require("node:assert");
const { spawnSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const vm = require("node:vm");

const [script, program, certificates] = process.argv.slice(2).map((name) => path.resolve(name));
const { mdmCheckVerified } = require(script);

const GRADATION = Buffer.from("size_mm,mass\n1,2\n2,1\n3,0\n");
const CERTIFICATE = Buffer.from("mdm-certificate 1\nlaw 3\nparticles 4\nscale 10\nclass 1 3 1.5 1.5\nchain 2\nend\n");
const TOO_LARGE = "p: more than this program can hold: use mdm-check\n";

function pairs(folder) {
  const files = fs.readdirSync(path.join(certificates, folder));
  return files.filter((name) => name.endsWith(".proof")).map((proof) => {
    const stem = proof.slice(0, -".proof".length);
    const gradation = files.find((name) => name === stem + ".csv" || name === stem + ".json");
    assert.ok(gradation, proof);
    return [gradation, proof].map((name) => path.join(certificates, folder, name));
  });
}

const read = (name) => [Buffer.from(name), fs.readFileSync(name)];

/// A result as the bytes that a program prints, so that no byte is lost in the comparison.
function printed({ code, output, error }) {
  return { code, output: Buffer.from(output).toString("latin1"), error: Buffer.from(error).toString("latin1") };
}

function native(command, args, cwd) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd, encoding: "latin1" });
  return { code: status, output: stdout, error: stderr };
}

for (const [folder, code] of [["accepted", 0], ["rejected", 1], ["unparsable", 2]])
  test(`all pairs of ${folder} have the program's verdict, line and message`, () => {
    const all = pairs(folder);
    assert.ok(all.length > 80, `${all.length} pairs`);
    for (const [gradation, certificate] of all) {
      const result = mdmCheckVerified(...read(gradation), ...read(certificate));
      // Numbers of so many digits need more than the stack that is there.
      if (/\d{10000}/.test(fs.readFileSync(certificate, "latin1"))) {
        const message = `${certificate}: more than this program can hold: use mdm-check\n`;
        assert.deepStrictEqual(printed(result), { code: 2, output: "", error: message });
        continue;
      }
      assert.deepStrictEqual(printed(result), native(program, [gradation, certificate]), certificate);
      assert.strictEqual(result.code, code);
    }
  });

for (const [folder, code] of [["accepted", 0], ["rejected", 1], ["unparsable", 2]])
  test(`all blends of ${folder} have the program's verdict, line and message`, () => {
    const within = path.join(certificates, "blends", folder);
    const cases = fs.readdirSync(within).filter((name) => fs.statSync(path.join(within, name)).isDirectory());
    assert.ok(cases.length >= 10, `${cases.length} blends`);
    for (const one of cases) {
      const files = ["limits.csv", "1.csv", "2.csv", "proof"].map((name) => path.join(within, one, name));
      const result = mdmCheckVerified(...files.flatMap(read));
      assert.deepStrictEqual(printed(result), native(program, files), one);
      assert.strictEqual(result.code, code);
    }
  });

test("names and bytes that are no UTF-8 have the program's message", () => {
  const folder = Buffer.from(fs.mkdtempSync(path.join(os.tmpdir(), "mdm-")));
  const names = [Buffer.from([0xff, 0x67]), Buffer.from([0x70, 0xc3])];
  const within = (name) => Buffer.concat([folder, Buffer.from("/"), name]);
  const all = Buffer.from([...Array(256).keys()]);
  const texts = [
    [GRADATION, CERTIFICATE],
    [GRADATION, Buffer.concat([CERTIFICATE, all])],
    [Buffer.concat([GRADATION, all]), CERTIFICATE],
    [Buffer.concat([GRADATION, Buffer.from("\u00e4\u{1f3d6},x\n")]), CERTIFICATE],
    [Buffer.alloc(0), Buffer.alloc(0)],
  ];
  for (const [gradation, certificate] of texts) {
    fs.writeFileSync(within(names[0]), gradation);
    fs.writeFileSync(within(names[1]), certificate);
    const expected = native("sh", ["-c", `exec "$0" "$(printf '\\377g')" "$(printf 'p\\303')"`, program], folder.toString());
    assert.deepStrictEqual(printed(mdmCheckVerified(names[0], gradation, names[1], certificate)), expected);
  }
  fs.rmSync(folder.toString(), { recursive: true });
});

const check = (gradation, certificate) => mdmCheckVerified(Buffer.from("g"), gradation, Buffer.from("p"), certificate);

function rows(count) {
  const lines = Array.from({ length: count }, (_, i) => `${i + 1},${i < count - 1 ? 1 : 0}\n`);
  return Buffer.from("size_mm,mass\n" + lines.join(""));
}

test("what is too large is said, and the next verdict does not depend on it", () => {
  const before = check(GRADATION, CERTIFICATE);
  const manyBytes = Buffer.concat([Buffer.alloc(4 << 20, "#"), GRADATION]);
  for (const gradation of [rows(40000), manyBytes]) {
    assert.deepStrictEqual({ ...check(gradation, CERTIFICATE) }, { code: 2, output: "", error: TOO_LARGE });
    assert.deepStrictEqual(check(GRADATION, CERTIFICATE), before);
  }
});

test("the half megabyte of stack that a browser's worker has is enough for a box and for 1000 classes", () => {
  const [box] = pairs("accepted").filter(([, name]) => path.basename(name) === "box.proof");
  const run = (code) => spawnSync(process.execPath, ["--stack-size=480", "-e", code, script, ...box], { encoding: "utf8" }).stdout;
  const prelude = `const { readFileSync } = require("fs"); const [script, g, p] = process.argv.slice(1);
    const check = require(script).mdmCheckVerified; const name = Buffer.from("p");`;
  assert.strictEqual(run(prelude + "console.log(check(name, readFileSync(g), name, readFileSync(p)).code)"), "0\n");
  const many = `const rows = Buffer.from(${JSON.stringify(rows(1000).toString())});`;
  assert.strictEqual(run(prelude + many + "console.log(check(name, rows, name, readFileSync(p)).code)"), "1\n");
});

test("two checks after another are independent", () => {
  const [good, bad] = ["accepted", "rejected"].map((folder) => pairs(folder).find(([, name]) => /cylinder|scale/.test(name)));
  const results = [good, bad, good, bad].map(([g, c]) => mdmCheckVerified(...read(g), ...read(c)));
  assert.deepStrictEqual(results.map((r) => r.code), [0, 1, 0, 1]);
  assert.deepStrictEqual(results[0], results[2]);
  assert.deepStrictEqual(results[1], results[3]);
});

test("a page that allows no code from text and has no network runs it", () => {
  const text = fs.readFileSync(script, "utf8");
  for (const forbidden of [/\beval\s*\(/, /\bFunction\s*\(/, /\bimport\s*\(/, /\bimportScripts\b/, /\bfetch\b/,
    /XMLHttpRequest/, /WebSocket/, /EventSource/, /sendBeacon/, /createElement/, /<\/script/i])
    assert.doesNotMatch(text, forbidden);
  const bare = vm.createContext({}, { codeGeneration: { strings: false, wasm: false } });
  assert.throws(() => vm.runInContext("eval('1')", bare), { name: "EvalError" });
  vm.runInContext(text, bare);
  for (const certificate of [CERTIFICATE, Buffer.from("")])
    assert.deepStrictEqual(
      { ...bare.mdmCheckVerified(Buffer.from("g"), GRADATION, Buffer.from("p"), certificate) },
      { ...check(GRADATION, certificate) });
});
