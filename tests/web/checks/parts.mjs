// Parts of the page that need no browser.

import { createHash } from "node:crypto";

import { commandLine } from "../../../src/web/page/command_line.js";
import { columnsWithoutHeader } from "../../../src/web/page/header.js";
import { fragmentOf, questionOf } from "../../../src/web/page/link.js";
import { enclosed, grouped, rounded, toDouble } from "../../../src/web/page/numbers.js";
import { sha256 } from "../../../src/web/page/sha256.js";
import de from "../../../src/web/page/texts/de.js";
import en from "../../../src/web/page/texts/en.js";

async function bothLanguagesHaveTheSameTexts(expect) {
  const placeholders = (text) => (text.match(/\{\w+\}/g) ?? []).sort().join();
  expect("the same keys", Object.keys(en).join() === Object.keys(de).join());
  for (const key of Object.keys(en)) {
    expect(`${key}: the same values`, placeholders(en[key]) === placeholders(de[key] ?? ""));
  }
}

async function digestsAreThoseOfNode(expect) {
  for (const length of [0, 1, 3, 55, 56, 57, 63, 64, 65, 119, 120, 128, 1000, 100_003]) {
    const bytes = Uint8Array.from({ length }, (_, i) => (i * 7919) >> 3);
    expect(`${length} bytes`, sha256(bytes) === createHash("sha256").update(bytes).digest("hex"));
  }
}

async function linksAreReadAgain(expect) {
  const bytes = Uint8Array.from({ length: 3000 }, (_, i) => (i * i) % 256);
  const question = { name: "Löß.csv", options: { tolerance: "1" }, bytes };
  const again = await questionOf(await fragmentOf(question));
  expect("the name", again.name === question.name);
  expect("the options", again.options.tolerance === "1");
  expect("the bytes", Buffer.from(again.bytes).equals(Buffer.from(bytes)));
  expect("none without a kind", (await questionOf("answer")) === null);
  const noise = Uint8Array.from({ length: 200_000 }, () => 256 * Math.random());
  expect("what is too long is none", (await fragmentOf({ ...question, bytes: noise })) === null);
}

async function numbersAreShownAsTheyAre(expect) {
  expect("groups", grouped("1234567") === "1\u202f234\u202f567" && grouped("123") === "123");
  expect("rounded", rounded(3.86) === "3.86" && rounded(0) === "0" && rounded(100) === "100" && rounded(12.34567) === "12.35");
  expect("large", rounded(31491.47) === "31490");
  expect("fractions", toDouble("1/3") === 1 / 3 && toDouble("2.5") === 2.5 && toDouble("-3/4") === -0.75);
  expect("enclosures", enclosed(["0.1", "0.2"]) === "0.1…" && enclosed(["2", "2"]) === "2");
}

async function commandsAreQuoted(expect) {
  const command = commandLine({ gradation: "a b'c.csv", flags: ["--tolerance", "retained:1%"], proofName: "p", checkedName: "$x" });
  expect(command, command === `mdm solve 'a b'\\''c.csv' --tolerance retained:1% --proof p && mdm-check '$x' p`);
}

async function headersAreTold(expect) {
  const without = ["4.75\t100\n2\t80", "4,75;100\n", "\r\n0.075;12\n", "No. 4,100", "#10,80", '"3/8","99"', "pan,3", "<0.063\t4"];
  for (const content of without) expect(`${content}: none`, columnsWithoutHeader(content) === 2);
  expect("three columns", columnsWithoutHeader("4.75\t12.5\t100") === 3);
  const others = ["size_mm,mass\n1,2", "Sieve\tPassing", "", "4.75", "0.075 12\n", "2024 report of the laboratory", '{"sizes":[1,2]}', "# a,b"];
  for (const content of others) expect(`${content}: no such table`, columnsWithoutHeader(content) === 0);
}

export const alone = [
  bothLanguagesHaveTheSameTexts, digestsAreThoseOfNode, linksAreReadAgain, numbersAreShownAsTheyAre, commandsAreQuoted,
  headersAreTold,
];
