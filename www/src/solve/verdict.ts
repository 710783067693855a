// What a solver's answer means, in words.
import type { SolveOptions } from "../core.js";
import type { Result } from "../state/answer.js";
import type { Solver } from "../state/form.js";
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
const heeded: Record<Solver, (options: SolveOptions) => string | null> = {
  exact: both,
  ip: both,
  satisficing: both,
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

/** No goal difference is larger, whatever the problem. */
const LARGEST = 1;

/** The figures of plans are fractions: the same one can come out of two sums. */
const sameOrMore = (one: number, other: number): boolean => one > other - 1e-9;

/** Whether every plan that keeps to the second options keeps to the first. */
const isWider = (one: SolveOptions | undefined, other: SolveOptions): boolean =>
  (["k", "j", "horizon"] as const).every((name) => one?.[name] === undefined || one[name] === other[name]);

/** Why no better plan exists, where that is known; `optimum`: the answer of the exact search to the same question. */
function unbeaten({ options, outcome: { goal_difference: own } }: Result, optimum: Result | null): string {
  if (own === null) return "";
  if (sameOrMore(own, LARGEST)) return "No plan has a larger one.";
  const best = optimum?.outcome;
  const proved = best?.status === "optimal" && best.goal_difference !== null && sameOrMore(own, best.goal_difference);
  return proved && isWider(optimum?.options, options) ? "That is the best possible." : "";
}

/** What the answer leaves open, as a sentence. */
export function caveat({ options, outcome }: Result, optimum: Result | null): string {
  const { status, limit } = outcome;
  const known = unbeaten({ options, outcome }, optimum);
  if (status === "solved") {
    if (known !== "") return known;
    return options.solver === "baseline" ? "It looks for no better plan." : "A better plan may exist.";
  }
  const why = limit === undefined || limit === "stopped on request" ? "" : ` (${limit})`;
  if (status === "feasible") {
    return `It was stopped before the proof${why}${known === "" ? "; a better plan may exist." : `. ${known}`}`;
  }
  if (status === "limit") return `No plan was found and nothing is proved${why}.`;
  return "";
}
