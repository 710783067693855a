// The outcome of a solve whose worker was ended before it could give one: the best that it had reported.
import type { Progress, SolveOptions, Trace } from "../core.js";
import type { Answered } from "./protocol.js";

/** `trace` is the replay of the last reported plan, null where none was reported. */
export function keptOutcome(options: SolveOptions, last: Progress | null, trace: Trace | null): Answered {
  const end = trace?.steps.at(-1);
  return {
    status: end === undefined ? "limit" : "feasible",
    solver: options.solver,
    horizon: end === undefined ? null : (last?.plan?.length ?? null),
    plan: end === undefined ? null : (last?.plan ?? null),
    goals: end?.goals ?? null,
    goal_difference: end?.goal_difference ?? null,
    stats: {},
  };
}
