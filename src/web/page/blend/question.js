// What is asked of mdm blend: files with names that differ, and the words of the command line.

import { withPoint } from "../numbers.js";

/** Aims that are about a target. */
export const AIMS_WITH_TARGET = ["deviation", "max-deviation", "squares"];

/** The files of a question, by their names. */
export function filesOf({ stockpiles, limits }) {
  return Object.fromEntries([...stockpiles, limits].map(({ name, blob }) => [name, blob]));
}

/** The words of mdm blend for a question: {stockpiles: [{name, blob, cost, id}], limits, step, aim, target}. */
export function blendWords({ stockpiles, limits, step, aim, target }) {
  return [
    "blend",
    ...stockpiles.map(({ name }) => name),
    "--spec", limits.name,
    ...(aim === "cost"
      ? stockpiles.filter(({ cost }) => cost.trim()).map(({ id, cost }) => `--cost=${id}=${withPoint(cost)}`)
      : []),
    ...(AIMS_WITH_TARGET.includes(aim) ? [`--target=${withPoint(target)}`] : []),
    "--minimise", aim,
    ...(step.trim() ? [`--step=${withPoint(step)}`] : []),
  ];
}

/** The words of mdm-check for a proof of it. */
export const checkWords = ({ stockpiles, limits }, proof) => [limits.name, ...stockpiles.map(({ name }) => name), proof];
