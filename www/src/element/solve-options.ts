// What a page's script asks of a solver, as the form has it.
import type { SolveOptions } from "../core.js";
import { type Form, solverNames } from "../state/form.js";

/** What the playground's form can ask for; `null` takes a number away. */
export interface ElementSolveOptions extends Pick<SolveOptions, "encoding"> {
  solver?: SolveOptions["solver"];
  k?: number | null;
  j?: number | null;
  horizon?: SolveOptions["horizon"] | null;
  horizon_step?: number | null;
}

const fields = {
  ...{ solver: "solver", encoding: "encoding", k: "k", j: "j" },
  ...{ horizon: "horizon", horizon_step: "horizonStep" },
} as const satisfies Record<keyof ElementSolveOptions, keyof Form>;

const names = {
  solver: solverNames,
  encoding: ["paper", "belief-flow"],
} as const satisfies { [field in keyof Form]?: readonly Form[field][] };

/** What is not asked for stays as it is. Throws a sentence for what the form cannot ask for. */
export function changeOf(options: unknown): Partial<Form> {
  if (typeof options !== "object" || options === null || Array.isArray(options))
    throw new Error(`“${options}” can’t be used as options; expected an object, as { solver: "exact" }.`);
  const change: Partial<Record<keyof Form, unknown>> = {};
  for (const [option, value] of Object.entries(options)) {
    if (value === undefined) continue;
    if (!isOption(option)) throw new Error(unknown(option));
    const field = fields[option];
    if (field === "solver" || field === "encoding") change[field] = oneOf(names[field], value, option);
    else change[field] = value === null || value === "any" ? "" : String(value);
  }
  return change as Partial<Form>;
}

const isOption = (option: string): option is keyof ElementSolveOptions => Object.hasOwn(fields, option);

const unknown = (option: string): string =>
  `“${option}” is no option that a playground knows; expected ${Object.keys(fields).join(", ")}. ` +
  "The other options of a solver are for mo-copp/core, or the command.";

function oneOf<Name extends string>(names: readonly Name[], given: unknown, option: string): Name {
  const found = names.find((name) => name === given);
  if (found === undefined) throw new Error(`“${given}” can’t be used as the ${option}; expected ${names.join(", ")}.`);
  return found;
}
