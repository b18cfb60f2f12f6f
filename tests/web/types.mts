// What the types of the JavaScript module allow; each @ts-expect-error is a mistake that they find.
import { InputError, batch, blend, check, describe, judge, run, solve, tradeoff, verify } from "exactmdm";

const { answer, proof } = await solve("size_mm,mass\n1,2\n2,0\n", { tolerance: "retained:1%", minPerClass: 2, proof: true });
const particles: string | null = answer.particles;
const quantities: (string | null)[] = answer.classes.map((one) => one.quantity);
const [lower]: string[] = answer.classes[0]?.size ?? [];
if (proof !== null) {
  const { verdict } = await check({ sizes: ["1", "2"], masses: ["1", "0"] }, proof);
  const accepted: boolean = verdict === "accepted";
  // @ts-expect-error there is no such verdict
  const mistaken: boolean = verdict === "maybe";
}
const answers = await batch([{ sizes: ["1", "2"], masses: ["1", "0"] }], { timeLimit: 1 });
const result = await run(["solve", "a.csv"], { "a.csv": new Uint8Array() }, ({ least }) => least.length);
const code: number = result.code;
// @ts-expect-error numbers are strings
const number: number = answer.particles;
// @ts-expect-error a gradation is needed
await solve();
// @ts-expect-error there is no such kind
await tradeoff("", { kind: "mostly" });
// @ts-expect-error a tolerance is a text or a number, or several
await solve("", { tolerance: true });
await solve("", { tolerance: ["retained:1%", "passing:2%"], band: new Uint8Array(), specimen: "box:1x2x3", voidRatio: "0.6" });
await verify("", "", { contactGap: 0, from: "xyzr", packing: true, unit: "um" });
await tradeoff("", { kind: "passing", tolerances: "0,1", onProgress: ({ least }) => least.length });
await describe("", { liquidLimit: 30, plasticLimit: 22, extrapolate: true, digits: 4 });
const error: Error = new InputError("a.csv:1: ...");
await judge({ A: "" }, "astm-c33-fine", { limit: ["FM=..3"], rounding: 0.1 });
const mix = await blend({ A: "", B: { sizes: ["1", "2"], masses: ["1", "0"] } }, "", { cost: { A: 7, B: "9" }, share: { A: "10.." } });
const blended: string | null = mix.blended;
// @ts-expect-error stockpiles have names
await blend(["", ""], "");
