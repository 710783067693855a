// What is asked of a solver, as the command that asks the same.
import type { SolveOptions } from "../core.js";

/** `file`: the document, as the page saves it. */
export function commandFor(file: string, { solver, encoding, horizon, horizon_step, k, j }: SolveOptions): string {
  const options: [name: string, value: string | number | undefined][] = [
    ["solver", solver],
    ["encoding", encoding],
    ["horizon", horizon],
    ["horizon-step", horizon_step],
    ["k", k],
    ["j", j],
  ];
  const given = options.flatMap(([name, value]) => (value === undefined ? [] : [`--${name} ${value}`]));
  return ["mo-copp solve", file, ...given].join(" ");
}
