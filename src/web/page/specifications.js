// The specifications that come with the page.

import { make } from "./dom.js";
import coarse57 from "specifications/astm-c33-57.csv";
import coarse67 from "specifications/astm-c33-67.csv";
import fine from "specifications/astm-c33-fine.csv";
import concrete0_2 from "specifications/en12620-0-2.csv";
import concrete0_4 from "specifications/en12620-0-4.csv";
import concrete0_8 from "specifications/en12620-0-8.csv";
import concrete16_32 from "specifications/en12620-16-32.csv";
import concrete2_8 from "specifications/en12620-2-8.csv";
import concrete4_8 from "specifications/en12620-4-8.csv";
import concrete8_16 from "specifications/en12620-8-16.csv";
import iowa12a from "specifications/iowa-subbase-12a.csv";
import iowa14 from "specifications/iowa-subbase-14.csv";
import superpave9 from "specifications/superpave-9.5.csv";
import superpave12 from "specifications/superpave-12.5.csv";
import superpave19 from "specifications/superpave-19.csv";
import superpave25 from "specifications/superpave-25.csv";
import superpave37 from "specifications/superpave-37.5.csv";

/** The specifications that mdm knows by their names. */
export const SPECIFICATIONS = {
  "astm-c33-fine": fine,
  "astm-c33-57": coarse57,
  "astm-c33-67": coarse67,
  "en12620-0-2": concrete0_2,
  "en12620-0-4": concrete0_4,
  "en12620-0-8": concrete0_8,
  "en12620-2-8": concrete2_8,
  "en12620-4-8": concrete4_8,
  "en12620-8-16": concrete8_16,
  "en12620-16-32": concrete16_32,
  "iowa-subbase-12a": iowa12a,
  "iowa-subbase-14": iowa14,
  "superpave-9.5": superpave9,
  "superpave-12.5": superpave12,
  "superpave-19": superpave19,
  "superpave-25": superpave25,
  "superpave-37.5": superpave37,
};

/** Offers them in a select element, by their names. */
export function offerSpecifications(select) {
  select.append(...Object.keys(SPECIFICATIONS).map((name) => make("option", { value: name }, name)));
}
