// The example of the Blend section, which comes with the page.

import limits from "blend-example/limits.csv";
import a from "blend-example/A.csv";
import b from "blend-example/B.csv";
import c from "blend-example/C.csv";
import d from "blend-example/D.csv";

/** Four stockpiles with their costs, and limits (tutorsglobe.com, question 52609483). */
export const EXAMPLE = {
  stockpiles: [
    { name: "A.csv", text: a, cost: "7.00" },
    { name: "B.csv", text: b, cost: "10.82" },
    { name: "C.csv", text: c, cost: "9.51" },
    { name: "D.csv", text: d, cost: "8.88" },
  ],
  limits: { name: "limits.csv", text: limits },
};
