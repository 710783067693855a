// What a page's script asks of a solver, as the form has it.
import type { SolveOptions } from "../core.js";
import { type Form, solverNames } from "../state/form.js";

const encodings = ["paper", "belief-flow"] as const;

/** What is not asked for stays as it is. Throws a sentence for a name that there is none of. */
export function changeOf({ solver, encoding, k, j, horizon }: Partial<SolveOptions>): Partial<Form> {
  const change: Partial<Form> = {};
  if (solver !== undefined) change.solver = oneOf(solverNames, solver, "solver");
  if (encoding !== undefined) change.encoding = oneOf(encodings, encoding, "encoding");
  for (const [name, value] of Object.entries({ k, j, horizon })) {
    if (value === undefined) continue;
    change[name as "k" | "j" | "horizon"] = value === null || value === "any" ? "" : String(value);
  }
  return change;
}

function oneOf<Name extends string>(names: readonly Name[], given: unknown, option: string): Name {
  const found = names.find((name) => name === given);
  if (found === undefined) throw new Error(`“${given}” can’t be used as the ${option}; expected ${names.join(", ")}.`);
  return found;
}
