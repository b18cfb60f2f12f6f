// Real gradations of the project's examples; where each comes from is its first line.

import athabasca from "examples/athabasca-sand.csv";
import hostun from "examples/hostun-rf-sand.csv";
import c778 from "examples/c778-graded-sand.csv";
import cen from "examples/cen-standard-sand.csv";
import ottawa from "examples/ottawa-f65-sand.csv";
import limestone from "examples/limestone-pfc.csv";

export const EXAMPLES = [
  { title: "Athabasca", name: "athabasca-sand.csv", text: athabasca },
  { title: "Hostun RF", name: "hostun-rf-sand.csv", text: hostun },
  { title: "ASTM C778", name: "c778-graded-sand.csv", text: c778 },
  { title: "CEN EN 196-1", name: "cen-standard-sand.csv", text: cen },
  { title: "Ottawa F-65", name: "ottawa-f65-sand.csv", text: ottawa },
  { title: "Limestone, PFC", name: "limestone-pfc.csv", text: limestone },
];
