// The smallest sets of particles that match sieve analyses, exactly, with proofs. Exact numbers are strings, as in the
// JSON formats: "2498", "0.0900923324743497".

/** A gradation: the text or the bytes of a file in any of the program's formats, or a JSON gradation as an object. */
export type GradationInput = string | Uint8Array | object;

/** An interval around an irrational number, or twice an exact one. */
export type Enclosure = [lower: string, upper: string];

/** Options in the words of the command line: `minPerClass: 2` is `--min-per-class 2`, `true` is an option alone. */
export interface Options {
  /** The name of the file, if the gradation is in a format that its ending tells. */
  name?: string;
  [option: string]: unknown;
}

/** What a search knows: no match has fewer particles than `least`, and one has `particles`, if any is known. */
export interface Bounds {
  least: string;
  particles: string | null;
}

export interface SolveOptions extends Options {
  /** Such as `"retained:1%"`. */
  tolerance?: string;
  /** At least so many particles in each class. */
  minPerClass?: number | string;
  /** The search ends after so many seconds; the answer then has bounds. */
  timeLimit?: number | string;
  /** With the proof of the answer. */
  proof?: boolean;
  /** Called some ten times a second during a long search. */
  onProgress?: (bounds: Bounds) => void;
}

export interface AnswerClass {
  lower: string;
  upper: string;
  mass: string;
  quantity: string | null;
  size: Enclosure | null;
  [more: string]: unknown;
}

/** An answer as mdm-answer-1.schema.json has it. */
export interface Answer {
  schema: "mdm-answer-1";
  id: string;
  status: "optimal" | "feasible" | "unknown" | "none" | (string & {});
  particles: string | null;
  lower_bound: string | null;
  unit: string;
  classes: AnswerClass[];
  notes: string[];
  versions: Record<string, string>;
  [more: string]: unknown;
}

/** What the checker says: its line, and the reason where that is not acceptance. */
export interface Verdict {
  verdict: "accepted" | "refused" | "malformed";
  line: string;
  reason: string;
}

/** What a run of a program gives: exit code, what it prints, and the files that it has written. */
export interface Run {
  code: number;
  out: string;
  err: string;
  files: Record<string, Uint8Array>;
}

/** The program's message for an input that it cannot take; it names options as they are written here, `minPerClass`. */
export class InputError extends Error {}

/** The smallest match. Rejects with InputError. Blocks its thread while it searches: use a worker for long searches. */
export function solve(
  gradation: GradationInput,
  options?: SolveOptions,
): Promise<{ answer: Answer; proof: string | null }>;

/** Whether a proof proves its claim of a gradation, by mdm-check, a program of its own. */
export function check(gradation: GradationInput, proof: string | Uint8Array, options?: Options): Promise<Verdict>;

/** The answers of many JSON gradations, in their order. */
export function batch(gradations: (string | object)[], options?: Options): Promise<Answer[]>;

/** Sizes D10 to D60, coefficients, classification and more, as mdm-describe-1 has them. */
export function describe(gradation: GradationInput, options?: Options): Promise<Record<string, unknown>>;

/** The gradation in its canonical form. */
export function convert(gradation: GradationInput, options?: Options): Promise<string>;

/** How far a sample of particles is from a gradation, as mdm-verify-1 has it. */
export function verify(
  gradation: GradationInput,
  sample: string | Uint8Array,
  options?: Options & { sampleName?: string },
): Promise<Record<string, unknown>>;

/** The smallest number of particles for each of some tolerances. */
export function tradeoff(
  gradation: GradationInput,
  options?: Options & { onProgress?: (bounds: Bounds) => void },
): Promise<Record<string, unknown>>;

/** Runs `mdm` as on the command line, with these files in its folder. */
export function run(
  commandLine: string[],
  files?: Record<string, string | Uint8Array | object>,
  onProgress?: (bounds: Bounds) => void,
): Promise<Run>;

/** Runs `mdm-check` as on the command line. */
export function runCheck(commandLine: string[], files?: Record<string, string | Uint8Array | object>): Promise<Run>;
