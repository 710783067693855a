// What the person has chosen in the form, as typed, and what of it goes to the core.
import type { SolveOptions } from "../core.js";

type Solver = SolveOptions["solver"];
type Field = "encoding" | "k" | "j" | "horizon";

export interface Form {
  solver: Solver;
  encoding: NonNullable<SolveOptions["encoding"]>;
  k: string;
  j: string;
  horizon: string;
}

export const emptyForm: Form = { solver: "exact", encoding: "belief-flow", k: "", j: "", horizon: "" };

/** The solvers in the order shown: their name, what they do, and which of the fields they read. */
export const solvers: Record<Solver, { title: string; about: string; fields: readonly Field[] }> = {
  exact: {
    title: "Exact search",
    about: "Looks at every position and both beliefs: the largest goal difference there is.",
    fields: ["k", "j", "horizon"],
  },
  ip: {
    title: "Integer program",
    about: "The best plan of one length, from linear inequalities; the length is raised until there is a plan.",
    fields: ["encoding", "k", "j", "horizon"],
  },
  search: {
    title: "Heuristic search",
    about: "The first plan that keeps to both bounds.",
    fields: ["k", "j", "horizon"],
  },
  baseline: {
    title: "Baseline",
    about: "Walks to the goal and thinks of no observer.",
    fields: [],
  },
  obfuscate: {
    title: "Obfuscate only",
    about: "Hides from the enemy and does not mind the friend.",
    fields: ["k"],
  },
  legible: {
    title: "Legible only",
    about: "Speaks to the friend and does not mind the enemy.",
    fields: ["j"],
  },
};

export const solverNames = Object.keys(solvers) as Solver[];

export const reads = (form: Form, field: Field): boolean => solvers[form.solver].fields.includes(field);

/** The options for the core, or a sentence that says which field can't be read. */
export function optionsOf(form: Form): SolveOptions | string {
  const options: SolveOptions = { solver: form.solver };
  if (reads(form, "encoding")) options.encoding = form.encoding;
  for (const field of ["k", "j", "horizon"] as const) {
    const text = form[field].trim();
    if (!reads(form, field) || text === "") continue;
    if (!/^\d{1,6}$/.test(text)) return `${fieldNames[field]} must be a whole number; found “${text}”.`;
    options[field] = Number(text);
  }
  return options;
}

/** The options of the exact search within the same bounds. */
export const exactOptions = (form: Form): SolveOptions | string => optionsOf({ ...form, solver: "exact" });

const fieldNames = { k: "k", j: "j", horizon: "The plan length" };
