// The picture of a mix: mdm blend mixes the stockpiles in these shares, and mdm plot draws all of them and the limits.

import { byId, fill, make } from "../dom.js";
import { freeName } from "../files.js";
import { Latest } from "../latest.js";
import { drawn } from "../picture.js";
import { Stopped } from "../programs.js";
import { saidLines } from "../said.js";
import { text } from "../texts.js";
import { blender } from "../workers.js";
import { HUNDRED, times } from "./fraction.js";
import { filesOf } from "./question.js";

/** Shares are drawn to so many decimals of a percent. */
const DECIMALS = 4;
const UNIT = 10n ** BigInt(DECIMALS);
/** A specification of a sieve that limits nothing: for the mix of any shares. */
const unlimited = (size) => `size_mm,passing_min_percent,passing_max_percent\n${size},0,100\n`;

/** Shares as whole numbers of such decimals, of which the last one takes the rest. */
function wholeShares(shares) {
  const units = shares.map((share) => {
    const { numerator, denominator } = times(HUNDRED, share);
    return (numerator * UNIT) / denominator;
  });
  const others = units.slice(0, -1);
  return [...others, 100n * UNIT - others.reduce((all, one) => all + one, 0n)];
}

const decimal = (units) => `${units / UNIT}.${String(units % UNIT).padStart(DECIMALS, "0")}`;

/** The gradation of the mix; null where the program does not make one. */
async function mixed({ question, shares, coarsest }, names) {
  const { stockpiles } = question;
  const words = [
    "blend", ...stockpiles.map(({ name }) => name), "--spec", names.limits, "--minimise", "none",
    "--step", `0.${"1".padStart(DECIMALS, "0")}%`,
    ...wholeShares(shares).map((units, i) => `--share=${stockpiles[i].id}=${decimal(units)}%`),
    "--blended", names.mix, "--quiet", "--format", "json", "-o", names.report,
  ];
  const files = { ...filesOf(question), [names.limits]: new Blob([unlimited(coarsest)]) };
  const { files: written, err } = await blender.run(words, files);
  return { mix: written[names.mix] ?? null, err };
}

let wanted = null;

async function draw() {
  const place = byId("blend-picture");
  if (wanted === null) return fill(place);
  const { question } = wanted;
  const taken = Object.keys(filesOf(question));
  const names = {};
  const choose = (key, name) => taken.push((names[key] = freeName(name, taken)));
  choose("mix", `${text("blend.mix")}.csv`);
  choose("limits", "no-limits.csv");
  choose("report", "mix-report.json");
  try {
    const { mix, err } = await mixed(wanted, names);
    if (mix === null) return fill(place, saidLines("pre", {}, err.trim()));
    const beside = question.stockpiles.flatMap(({ name }) => ["--beside", name]);
    const words = [names.mix, ...beside, "--band", question.limits.name];
    const picture = await drawn(words, { ...filesOf(question), [names.mix]: mix }, wanted.width);
    if (wanted !== null) fill(place, picture.picture ?? saidLines("pre", {}, picture.err.trim()));
  } catch (error) {
    if (!(error instanceof Stopped)) fill(place, make("p", {}, text("ended", { message: error.message })));
  }
}

const drawing = new Latest({ job: draw, stop: () => {}, patience: 60_000, onChange: () => {} });

/** Draws a question's stockpiles and limits, and the mix of these shares; `coarsest` is a sieve. null takes the picture away. */
export function showPicture(mix) {
  wanted = mix && { ...mix, width: byId("blend-rows").clientWidth };
  drawing.request();
}
