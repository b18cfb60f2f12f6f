// The smallest sets of particles that match sieve analyses, exactly, with proofs. Exact numbers are strings, as in the
// JSON formats: "2498", "0.0900923324743497".

/** A gradation: the text or the bytes of a file in any of the program's formats, or a JSON gradation as an object. */
export type GradationInput = string | Uint8Array | object;

/** An interval around an irrational number, or twice an exact one. */
export type Enclosure = [lower: string, upper: string];

/**
 * Options in the words of the command line: `minPerClass: 2` is `--min-per-class 2`, `true` is an option alone. A file, such
 * as that of `band`, is its text or its bytes.
 */
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

// Options of commands, by src/ask/write_modules.
/** Options of `mdm solve`. */
export interface SolveWords {
  /**
   * The smallest match within a tolerance: retained:1%, passing:0.5%, total:1% (percentage points), retained:file,
   * passing:file (column tolerance_percent), laboratory, rounding; may be repeated.
   */
  tolerance?: string | number | (string | number)[];
  /**
   * The smallest match within the envelope in FILE: CSV with passing_min_percent and passing_max_percent of each
   * sieve, or a table with columns such as Lower and Upper.
   */
  band?: string | Uint8Array;
  /**
   * The least tolerance with which N particles suffice, of the kind that tolerance names without a value: retained
   * (as without it), passing or total.
   */
  particles?: number | string;
  /**
   * What particles chooses: tolerance, or size-factor, the least factor with which N particles of a specimen suffice
   * (tolerance).
   */
  by?: string;
  /** The steps of that tolerance in percentage points, or of that factor from 1 on (0.001). */
  grid?: number | string;
  /** At least R particles in every class with mass. */
  minPerClass?: number | string;
  /** The smallest match with at least N particles. */
  atLeast?: number | string;
  /**
   * At least the solids of a specimen: cylinder:DxH or box:AxBxC; lengths as 50mm, 63um, 2m, 0.5in, or in the file's
   * unit (mm for sieve names and phi; beside inches a unit is needed).
   */
  specimen?: string;
  /** Void ratio e of the specimen. */
  voidRatio?: number | string;
  /** At least this volume of solids, in the cube of the answer's unit. */
  solidsVolume?: number | string;
  /** No match if the smallest has more than N particles. */
  atMost?: number | string;
  /**
   * Mass of a particle of size x: sphere (x^3), power:a/b or power:2.5, sum:2*x^3+0.5*x^2 with x in mm, or
   * table:FILE, CSV with size_mm and particle_mass, from (0, 0) on and linear between its rows.
   */
  law?: string;
  /** Multiply every size of the gradation by K. */
  sizeFactor?: number | string;
  /** Leave out the classes below the sieve SIZE, as 63um or in the file's unit (before sizeFactor). */
  cutBelow?: number | string;
  /** Count the pan as SIZE, as 2um or in the file's unit, instead of 0 (before sizeFactor). */
  panSize?: number | string;
  /** Significant digits of sizes (15). */
  digits?: number | string;
  /** Robust (sizes far from the sieves) or upper (largest sizes). */
  scale?: string;
  /** Stop after so many steps (67108864), with what is certain. */
  maxSteps?: number | string;
  /** Stop after so many nodes of the search for a tolerance. */
  nodeLimit?: number | string;
  /** Stop after so many seconds. */
  timeLimit?: number | string;
  /**
   * Within a tolerance, stop at a match that has at most this part of its particles more than are certain, for
   * example 1e-6.
   */
  gap?: number | string;
}

/** Options of `mdm verify`. */
export interface VerifyWords {
  /**
   * What shares may differ by: retained:1% or 1% (percentage points, of each class), passing:0.5%, total:1%,
   * retained:file, passing:file, laboratory, rounding; none is 0; may be repeated, and all hold.
   */
  tolerance?: string | number | (string | number)[];
  /** What passes lies within the envelope in FILE, as for solve. */
  band?: string | Uint8Array;
  /** Take a size within EPS times an opening of it as that opening (0), for sizes computed in double: 1e-12. */
  snap?: number | string;
  /**
   * Format of SAMPLE: csv (size_mm,quantity; also size_um, size_m, size_in, size_phi or sieve), answer (JSON of mdm
   * solve), xyzr (x y z r a line), lammps-data, lammps-dump, liggghts-dump, vtk, vtp (VTK's XML in ASCII), diameters
   * (one a line), liggghts-insertion, mercurydpm (scripts and distributions of mdm export), extxyz (extended XYZ of
   * ASE and OVITO with radius among its Properties), esys (geometry or snapshot of ESyS-Particle with one worker),
   * lethe (insertion file), kratos (mdpa), musen (scene as text), gsd (HOOMD-blue), phasicflow (particlesDict of mdm
   * export) or dem-engine (CSV of spheres, or of clumps whose types are named r and the radius, as r0.00025); told
   * by the content if left out.
   */
  from?: string;
  /** Sizes are radii, whatever their name. */
  radius?: boolean;
  /** Sizes are diameters, whatever their name. */
  diameter?: boolean;
  /**
   * The column of sizes in a dump or CSV, or array in VTK, where it has a name of its own, such as c_r; with radius
   * or diameter; other columns that are not known are then passed over.
   */
  sizeColumn?: string;
  /**
   * Unit of SAMPLE: mm, um, m or in; if left out what the file states, else m for LAMMPS, LIGGGHTS, VTK,
   * ESyS-Particle, Lethe, Kratos, MUSEN, GSD, PhasicFlow and DEM-Engine if left out, for xyzr, extxyz and diameters
   * that of the gradation (mm for size_in, size_phi and sieve).
   */
  sizeUnit?: string;
  /** The timestep of a dump or of GSD, instead of the last; of several of that number the last. */
  timestep?: number | string;
  /**
   * Mass of a particle of size x: sphere (x^3), power:a/b or power:2.5, sum:2*x^3+0.5*x^2 with x in mm, or
   * table:FILE, CSV with size_mm and particle_mass, from (0, 0) on and linear between its rows.
   */
  law?: string;
  /** Multiply every size of the gradation by K. */
  sizeFactor?: number | string;
  /** Leave out the classes below the sieve SIZE, as 63um or in the file's unit (before sizeFactor). */
  cutBelow?: number | string;
  /** Count the pan as SIZE, as 2um or in the file's unit, instead of 0 (before sizeFactor). */
  panSize?: number | string;
  /** Significant digits of percents (6). */
  digits?: number | string;
  /**
   * What the places of the particles say too: void ratio, contacts, overlaps, floating particles, heights of the
   * classes; for files with x y z, of up to 20000 particles without this; the options below ask for it too.
   */
  packing?: boolean;
  /**
   * The space, from the origin, in the gradation's unit; without a height it ends at the top of the highest
   * particle, as the file's box does, which is taken without this.
   */
  box?: string;
  /**
   * The same as cylinder:DxH, or cylinder:D up to the top of the highest particle, which touches the axes' planes as
   * that of export does, or box:AxBxC.
   */
  specimen?: string;
  /** The axes that are periodic, such as xyz, or none; told by dumps and extended XYZ. */
  periodic?: string;
  /** The gap up to which two particles touch, in the gradation's unit (0). */
  contactGap?: number | string;
  /** What the inner part keeps away from walls, floor and top, in the gradation's unit (two largest diameters). */
  margin?: number | string;
}

/** Options of `mdm crosscheck`. */
export interface CrosscheckWords {
  /** How far sizes may be off, as a part of the size as stated (1e-9). */
  sizeTolerance?: number | string;
  /**
   * The smallest match within a tolerance: retained:1%, passing:0.5%, total:1% (percentage points), retained:file,
   * passing:file (column tolerance_percent), laboratory, rounding; may be repeated.
   */
  tolerance?: string | number | (string | number)[];
  /**
   * The smallest match within the envelope in FILE: CSV with passing_min_percent and passing_max_percent of each
   * sieve, or a table with columns such as Lower and Upper.
   */
  band?: string | Uint8Array;
  /** At least R particles in every class with mass. */
  minPerClass?: number | string;
  /** The smallest match with at least N particles. */
  atLeast?: number | string;
  /**
   * At least the solids of a specimen: cylinder:DxH or box:AxBxC; lengths as 50mm, 63um, 2m, 0.5in, or in the file's
   * unit (mm for sieve names and phi; beside inches a unit is needed).
   */
  specimen?: string;
  /** Void ratio e of the specimen. */
  voidRatio?: number | string;
  /** At least this volume of solids, in the cube of the answer's unit. */
  solidsVolume?: number | string;
  /**
   * Mass of a particle of size x: sphere (x^3), power:a/b or power:2.5, sum:2*x^3+0.5*x^2 with x in mm, or
   * table:FILE, CSV with size_mm and particle_mass, from (0, 0) on and linear between its rows.
   */
  law?: string;
  /** Multiply every size of the gradation by K. */
  sizeFactor?: number | string;
  /** Leave out the classes below the sieve SIZE, as 63um or in the file's unit (before sizeFactor). */
  cutBelow?: number | string;
  /** Count the pan as SIZE, as 2um or in the file's unit, instead of 0 (before sizeFactor). */
  panSize?: number | string;
  /** Stop the search for a smallest match after so many steps (67108864; undecided, exit 3). */
  maxSteps?: number | string;
  /** Stop after so many nodes of the search for a tolerance. */
  nodeLimit?: number | string;
}

/** Options of `mdm tradeoff`. */
export interface TradeoffWords {
  /**
   * What the tolerances are of: retained (percent in each class), passing (percent passing each sieve) or total (the
   * sum of all deviations of percent retained).
   */
  kind?: "retained" | "passing" | "total";
  /** Tolerances in percentage points (0,0.1,0.2,0.5,1,2,5); 0 is the exact match. */
  tolerances?: string;
  /**
   * Also the least tolerances with which so many particles suffice, and, of a specimen, the least size factors: a
   * list as 100,1000, or all for 1, 2, 5, 10, 20, ....
   */
  particles?: string;
  /** The steps of those tolerances in percentage points, and of those factors (0.001). */
  grid?: number | string;
}

/** Options of `mdm blend`. */
export interface BlendWords {
  /**
   * What a blend is to have least of: cost, deviation (the sum of the distances from the target), max-deviation (the
   * largest of them), squares (the sum of their squares) or none; without it cost where there is cost, deviation
   * where there is --target.
   */
  minimise?: string;
  /** The cost of a unit of mass of each stockpile, as A=12.5,B=9. */
  cost?: string | string[];
  /** Shares are whole numbers of steps: 1% (without this option), 0.5%, or masses as '5kg of 1000kg'. */
  step?: string;
  /** Limits of a stockpile's share: A=10..40%, A=10.., A=..40%, or A=25%. */
  share?: string | string[];
  /**
   * Limits of the blend's fineness modulus, FM=2.3..3.1 of ASTM C125 or FM-EN=2.4..3.0 of EN 12620, or of its
   * coarseness factor, CF=45..75: of what stays on 2.36 mm the percent that stays on 9.5 mm; either end may be left
   * out.
   */
  limit?: string | string[];
  /** So many stockpiles at most have a share. */
  atMostStockpiles?: number | string;
  /** The N best blends. */
  all?: number | string;
  /**
   * Where there is no blend, by how much the limits of the sieve SIZE alone must be widened; without it all limits
   * by the same.
   */
  relax?: number | string;
  /**
   * Report the ratios of the Bailey method, CA, FAc and FAf, for this nominal maximum particle size: 37.5mm, 25mm,
   * 19mm, 12.5mm, 9.5mm or 4.75mm.
   */
  bailey?: string;
  /** Stop after so many splits of the search, 1000000 without it. */
  nodeLimit?: number | string;
  /** Stop after so many seconds. */
  timeLimit?: number | string;
  /** The sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them. */
  specimenId?: string;
  /** The columns of sizes and masses: names, or numbers from 1 on. */
  columns?: string;
  /** What the values are: passing, retained, cumulative, or a name as in canonical CSV. */
  kind?: string;
  /** What the sizes are: mm, um, m, in, phi or sieve. */
  unit?: string;
  /** Leave out the first N lines or rows. */
  skip?: number | string;
  /** The sheet of a workbook (the first). */
  sheet?: string;
  /** What the rows of a sheet may lack of its initial mass (1%). */
  loss?: number | string;
  /**
   * Take all masses, or the values of a column that passes or is cumulative, to D significant digits before anything
   * else.
   */
  round?: number | string;
}

/** Options of `mdm describe`. */
export interface DescribeWords {
  /** More diameters D_P, the sizes that P percent of the mass pass: 5,16,84,90. */
  d?: string;
  /** Also the hydraulic conductivity after Kozeny and Carman at this void ratio. */
  voidRatio?: number | string;
  /** Of the fines, in percent; without limits they are low-plasticity silt. */
  liquidLimit?: number | string;
  /** Of the fines, in percent. */
  plasticLimit?: number | string;
  /** Take the pan as a sieve of this size. */
  panSize?: number | string;
  /** Continue the line through the two finest sieves into a pan at size 0. */
  extrapolate?: boolean;
}

/** Options of `mdm convert`. */
export interface ConvertWords {
  /** The sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them. */
  specimenId?: string;
  /** The columns of sizes and masses: names, or numbers from 1 on. */
  columns?: string;
  /** What the values are: passing, retained, cumulative, or a name as in canonical CSV. */
  kind?: string;
  /** What the sizes are: mm, um, m, in, phi or sieve. */
  unit?: string;
  /** Leave out the first N lines or rows. */
  skip?: number | string;
  /** The sheet of a workbook (the first). */
  sheet?: string;
  /** What the rows of a sheet may lack of its initial mass (1%). */
  loss?: number | string;
  /**
   * Take all masses, or the values of a column that passes or is cumulative, to D significant digits before anything
   * else.
   */
  round?: number | string;
}
// End of the options.

export interface SolveOptions extends Options, SolveWords, ConvertWords {
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
export function batch(
  gradations: (string | object)[],
  options?: Options & Omit<SolveWords, "particles" | "grid">,
): Promise<Answer[]>;

/** Sizes D10 to D60, coefficients, classification and more, as mdm-describe-1 has them. */
export function describe(
  gradation: GradationInput,
  options?: Options & DescribeWords & ConvertWords & { digits?: number },
): Promise<Record<string, unknown>>;

/** The gradation in its canonical form. */
export function convert(gradation: GradationInput, options?: Options & ConvertWords): Promise<string>;

/** How far a sample of particles is from a gradation, as mdm-verify-1 has it. */
export function verify(
  gradation: GradationInput,
  sample: string | Uint8Array,
  options?: Options & VerifyWords & ConvertWords & { sampleName?: string },
): Promise<Record<string, unknown>>;

/**
 * What a solver answers to a gradation: the quantities of its classes, ascending (all classes or those with mass), an
 * object as `mdm crosscheck` reads it from JSON, or nothing.
 */
export type SolverAnswer = (bigint | number | string)[] | Record<string, unknown> | null | undefined;

/**
 * Judges a solver's answers to a question about each gradation, as `mdm crosscheck` has it in JSON. That the question was
 * asked is yours to tell the solver; what it throws is the verdict "crashed".
 */
export function crosscheck(
  gradations: (object | string)[],
  solver: (gradation: Record<string, unknown>) => SolverAnswer | Promise<SolverAnswer>,
  options?: CrosscheckWords,
): Promise<Record<string, unknown>>;

export interface TradeoffOptions
  extends Options,
    Omit<SolveWords, "particles" | "digits" | "scale">,
    Omit<ConvertWords, "kind">,
    TradeoffWords {
  /** Called some ten times a second during a long search. */
  onProgress?: (bounds: Bounds) => void;
}

/** The smallest number of particles for each of some tolerances. */
export function tradeoff(
  gradation: GradationInput,
  options?: TradeoffOptions,
): Promise<Record<string, unknown>>;

/** What samples are judged by besides the limits of a specification. */
export interface JudgeOptions {
  /**
   * What it asks besides: "FM=2.3..3.1", the fineness modulus of ASTM C125, "FM-EN=..", that of EN 12620; "retained=..45%",
   * what passes a sieve of it and stays on the next.
   */
  limit?: string | string[];
  /** One unit of the last digit of all percents, or "none"; without it as they are printed. */
  rounding?: string | number;
  /** Significant digits (15). */
  digits?: number;
}

/**
 * Whether samples, given by their names, keep a specification, whatever was rounded in their reports, as mdm-judge-1 has
 * it: of an envelope, or of the name of one that comes with mdm, as "astm-c33-fine".
 */
export function judge(
  samples: Record<string, GradationInput>,
  specification: string | Uint8Array,
  options?: JudgeOptions,
): Promise<Record<string, unknown>>;

/** What a blend may be asked for. */
export interface BlendOptions extends Omit<BlendWords, "cost" | "share"> {
  /** The curve that is wished for. */
  /** A gradation, or a curve that is computed: "power45:19mm", "fuller:31.5mm", "andreasen:16mm,q=0.25,dmin=0.063mm". */
  target?: GradationInput;
  /** Of a unit of mass of each stockpile. */
  cost?: Record<string, string | number> | string | string[];
  /** Limits of shares: `{ sand: "10..40%" }`. */
  share?: Record<string, string> | string | string[];
  /** With a proof for `mdm-check`, of the files of specification and stockpiles. */
  proof?: boolean;
}

/**
 * The best mix of stockpiles, given by their names, within the limits of a specification (an envelope), or why there is
 * none, as mdm-blend-1 has it; `blended` is the gradation of the best blend.
 */
export function blend(
  stockpiles: Record<string, GradationInput>,
  specification: string | Uint8Array,
  options?: BlendOptions,
): Promise<{ answer: Record<string, unknown>; blended: string | null; proof: string | null }>;

/** Runs `mdm` as on the command line, with these files in its folder. */
export function run(
  commandLine: string[],
  files?: Record<string, string | Uint8Array | object>,
  onProgress?: (bounds: Bounds) => void,
): Promise<Run>;

/** Runs `mdm-check` as on the command line. */
export function runCheck(commandLine: string[], files?: Record<string, string | Uint8Array | object>): Promise<Run>;
