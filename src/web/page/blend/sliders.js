// A slider and a field for the share of each stockpile; the last one takes the rest.

import { byId, fill, make } from "../dom.js";
import { stem } from "../files.js";
import { toDouble, withPoint } from "../numbers.js";
import { text } from "../texts.js";
import { HUNDRED, ONE, ZERO, compared, inDecimals, inFull, parsed, ratio, times } from "./fraction.js";
import { withRest } from "./mix.js";

let rows = [];
let steps = 100;
let changed = () => {};

const percent = (share) => inDecimals(times(HUNDRED, share));

/** The share that a field says in percent; null if it says none. */
function shareIn(field) {
  const share = parsed(withPoint(field.value));
  return share && times(share, ratio(1, 100));
}

const isShare = (share) => share !== null && compared(share, ZERO) >= 0 && compared(share, ONE) <= 0;

/** What is shown of a share by its slider. */
function follow({ slider }, share) {
  slider.max = steps;
  slider.value = Math.round(steps * toDouble(inFull(share)));
  slider.setAttribute("aria-valuetext", `${percent(share)} %`);
}

function write(row, share) {
  row.share = share;
  row.field.value = percent(share);
  row.field.removeAttribute("aria-invalid");
  follow(row, share);
}

/**
 * The shares that the controls say: {shares}, or {problem}, why they are none. The last stockpile's controls are set to
 * the rest.
 */
export function readShares() {
  const others = rows.slice(0, -1);
  const bad = others.find(({ share }) => !isShare(share));
  if (bad) return { problem: text("blend.no-share", { value: bad.field.value, name: bad.name }) };
  const { shares, given } = withRest(others.map(({ share }) => share));
  const last = rows.at(-1);
  const isTooMuch = compared(given, ONE) > 0;
  write(last, isTooMuch ? ZERO : shares.at(-1));
  if (isTooMuch) return { problem: text("blend.too-much", { sum: percent(given) }) };
  return { shares };
}

/** Sets all shares. */
export function setShares(shares) {
  rows.forEach((row, i) => write(row, shares[i]));
}

/** Sets shares that are as equal as whole steps let them be. */
export function setEqualShares() {
  const each = ratio(Math.floor(steps / rows.length), steps);
  setShares(withRest(rows.slice(1).map(() => each)).shares);
}

/** The controls of a stockpile; `isRest` says that it takes the rest. */
function rowOf(sheet, isRest, { remove, cost }) {
  const name = stem(sheet.name);
  const slider = make("input", { type: "range", min: "0", step: "1", disabled: isRest });
  const field = make("input", { class: "short", autocomplete: "off", inputMode: "decimal", readOnly: isRest });
  const costField = make("input", { class: "short", autocomplete: "off", inputMode: "decimal", value: sheet.cost });
  const costLabel = make("label", { class: "blend-cost" }, make("span"), costField);
  const button = make("button", { type: "button", class: "plain" });
  const title = make("span", { class: "blend-name" });
  const element = make("div", { class: "blend-stockpile", role: "group", "aria-label": name },
    title, costLabel, button, slider, field, make("span", { "aria-hidden": "true" }, "%"));
  const row = { name, slider, field, costLabel, element, share: ZERO };
  row.writeTexts = () => {
    title.textContent = isRest ? `${name} ${text("blend.takes-rest")}` : name;
    costLabel.firstChild.textContent = text("blend.cost");
    button.textContent = text("blend.remove");
    button.setAttribute("aria-label", text("blend.remove.of", { name }));
    slider.setAttribute("aria-label", text("blend.share.of", { name }));
    field.setAttribute("aria-label", text("blend.percent.of", { name }));
  };
  slider.addEventListener("input", () => {
    write(row, ratio(slider.value, steps));
    changed();
  });
  field.addEventListener("input", () => {
    row.share = shareIn(field);
    const isGood = isShare(row.share);
    field.setAttribute("aria-invalid", String(!isGood));
    if (isGood) follow(row, row.share);
    changed();
  });
  costField.addEventListener("input", () => cost(costField.value));
  button.addEventListener("click", remove);
  row.writeTexts();
  return row;
}

/** Makes a row for each sheet; `on` has what is done when a sheet is removed, or its cost is changed. */
export function showSliders(sheets, on) {
  rows = sheets.map((sheet, i) =>
    rowOf(sheet, i === sheets.length - 1, { remove: () => on.remove(sheet), cost: (value) => on.cost(sheet, value) }));
  fill(byId("blend-stockpiles"), ...rows.map(({ element }) => element));
  if (rows.length > 0) setEqualShares();
}

/** The steps that the whole has; shares that are there stay as they are. */
export function setSteps(wanted) {
  steps = wanted;
  for (const row of rows) if (isShare(row.share)) follow(row, row.share);
}

export function showCosts(isShown) {
  for (const { costLabel } of rows) costLabel.hidden = !isShown;
}

export const writeSliderTexts = () => rows.forEach((row) => row.writeTexts());

/** `onChange` is told when a share is changed by hand. */
export function startSliders(onChange) {
  changed = onChange;
}
