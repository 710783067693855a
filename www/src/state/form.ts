// What the person has chosen in the form, as typed, and what of it goes to the core.
import type { SolveOptions } from "../core.js";

export type Solver = SolveOptions["solver"];
type Field = "encoding" | "k" | "j" | "horizon" | "horizonStep";

export interface Form {
  solver: Solver;
  encoding: NonNullable<SolveOptions["encoding"]>;
  k: string;
  j: string;
  horizon: string;
  horizonStep: string;
}

export const emptyForm: Form = {
  ...{ solver: "exact", encoding: "belief-flow" },
  ...{ k: "", j: "", horizon: "", horizonStep: "" },
};

/** The solvers in the order shown: their name, what they do, and which of the fields they read. */
export const solvers: Record<Solver, { title: string; about: string; fields: readonly Field[] }> = {
  exact: {
    title: "Exact search",
    about:
      "Follows positions with both beliefs, the best first: finds the largest goal difference there is, and proves it.",
    fields: ["k", "j", "horizon"],
  },
  ip: {
    title: "Integer program",
    about: "Writes all plans of one length as linear inequalities and finds the best of them, with a proof.",
    fields: ["encoding", "k", "j", "horizon", "horizonStep"],
  },
  satisficing: {
    title: "Satisficing search",
    about:
      "Takes the first plan that keeps to both bounds, or proves that there is none: for bounds where exact search takes long.",
    fields: ["k", "j", "horizon"],
  },
  search: {
    title: "Heuristic search",
    about:
      "Algorithm 1 of the paper: looks where it seems promising and takes the first plan that keeps to both bounds.",
    fields: ["k", "j", "horizon"],
  },
  baseline: {
    title: "Baseline",
    about: "Walks to the goal and thinks of no observer.",
    fields: ["horizon"],
  },
  obfuscate: {
    title: "Obfuscate only",
    about: "Hides from the enemy and does not mind the friend.",
    fields: ["k", "horizon"],
  },
  legible: {
    title: "Legible only",
    about: "Speaks to the friend and does not mind the enemy.",
    fields: ["j", "horizon"],
  },
};

export const solverNames = Object.keys(solvers) as Solver[];

export const reads = (form: Form, field: Field): boolean => solvers[form.solver].fields.includes(field);

/** The options for the core, or a sentence that says which field can't be read. */
export function optionsOf(form: Form): SolveOptions | string {
  const options: SolveOptions = { solver: form.solver };
  if (reads(form, "encoding")) options.encoding = form.encoding;
  for (const field of ["k", "j", "horizon", "horizonStep"] as const) {
    const text = form[field].trim();
    if (!reads(form, field) || text === "") continue;
    if (!/^\d+$/.test(text)) return `${fieldNames[field]} must be a whole number; found “${text}”.`;
    if (text.length > MOST_DIGITS) return `${fieldNames[field]} must be at most ${most[field]}; found “${text}”.`;
    options[field === "horizonStep" ? "horizon_step" : field] = Number(text);
  }
  return options;
}

/** The options of the exact search for the best of the plans that the chosen solver looks for. */
export function exactOptions(form: Form): SolveOptions | string {
  const options = optionsOf(form);
  if (typeof options === "string") return options;
  const { encoding, horizon_step, ...others } = options;
  return { ...others, solver: "exact" };
}

/** Numbers with more digits are above what the core takes, which says the rest of its ranges itself. */
const MOST_DIGITS = 6;

const most = { k: "the number of goals", j: "the number of goals", horizon: "10,000", horizonStep: "10,000" };

const fieldNames = { k: "k", j: "j", horizon: "The plan length", horizonStep: "The step" };
