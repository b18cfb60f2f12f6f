// Example and limits of the Blend section that come with the page.

import limits from "blend-example/limits.csv";
import a from "blend-example/A.csv";
import b from "blend-example/B.csv";
import c from "blend-example/C.csv";
import d from "blend-example/D.csv";
import coarse57 from "specifications/astm-c33-57.csv";
import coarse67 from "specifications/astm-c33-67.csv";
import fine from "specifications/astm-c33-fine.csv";
import superpave9 from "specifications/superpave-9.5.csv";
import superpave12 from "specifications/superpave-12.5.csv";
import superpave19 from "specifications/superpave-19.csv";
import superpave25 from "specifications/superpave-25.csv";
import superpave37 from "specifications/superpave-37.5.csv";

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

/** The specifications that mdm knows by their names. */
export const SPECIFICATIONS = {
  "astm-c33-fine": fine,
  "astm-c33-57": coarse57,
  "astm-c33-67": coarse67,
  "superpave-9.5": superpave9,
  "superpave-12.5": superpave12,
  "superpave-19": superpave19,
  "superpave-25": superpave25,
  "superpave-37.5": superpave37,
};
