// What a solver's answer means, in words.
import type { SolveOptions } from "../core.js";
import type { Result } from "../state/answer.js";
import { counted } from "../view/numbers.js";

/** In a word or two. What "bounds" are depends on what the solver heeds. */
export function verdict({ options, outcome }: Result): string {
  switch (outcome.status) {
    case "optimal":
      return "proved best";
    case "solved":
      return heeded[options.solver](options) ?? "reaches the goal";
    case "feasible":
      return "best found";
    case "infeasible":
      return "no plan";
    case "limit":
      return "stopped";
  }
}

const both = ({ k, j }: SolveOptions) => (k === undefined && j === undefined ? null : "meets the bounds");
/** What the solvers that stop at the first plan keep to; null where nothing was asked. */
const heeded: Record<SolveOptions["solver"], (options: SolveOptions) => string | null> = {
  exact: both,
  ip: both,
  search: both,
  obfuscate: ({ k }) => (k === undefined ? null : "meets the enemy’s bound"),
  legible: ({ j }) => (j === undefined ? null : "meets the friend’s bound"),
  baseline: () => null,
};

/** Among which plans it is the best: without that, "proved best" says too much. */
export function scope({ options, outcome }: Result): string {
  if (outcome.status !== "optimal" || outcome.plan === null) return "";
  const everyLength = options.solver === "exact" && options.horizon === undefined;
  const { k, j } = options;
  const bounds = k === undefined && j === undefined ? "" : " within the bounds";
  return ` of the plans of ${everyLength ? "every length" : counted(outcome.plan.length, "move")}${bounds}`;
}

/** Of how many moves the plans are that the proof is about; "" where it is about all. */
export function proved({ options, outcome }: Result): string {
  const { status, plan, horizon } = outcome;
  const oneLength = options.solver === "ip" || options.horizon !== undefined;
  const moves = plan?.length ?? horizon;
  if (!oneLength || (status !== "optimal" && status !== "infeasible") || moves == null) return "";
  return ` of ${counted(moves, "move")}`;
}

/** What the answer leaves open, as a sentence. */
export function caveat({ options, outcome }: Result): string {
  const { status, limit } = outcome;
  if (status === "solved") {
    return options.solver === "baseline" ? "It looks for no better plan." : "A better plan may exist.";
  }
  const why = limit === undefined || limit === "stopped on request" ? "" : ` (${limit})`;
  if (status === "feasible") return `It was stopped before the proof${why}; a better plan may exist.`;
  if (status === "limit") return `No plan was found and nothing is proved${why}.`;
  return "";
}
