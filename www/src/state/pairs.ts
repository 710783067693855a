// Which pairs of survivor counts plans can reach, as far as that is known.
import type { Outcome } from "../core.js";
import type { OpenDocument } from "./open-problem.js";

export type Pair = NonNullable<Outcome["pareto"]>[number];

/** What plans the points are all pairs of: of every plan, of plans of so many moves, or of no more than those found. */
export type Known = { kind: "all" } | { kind: "up to"; moves: number } | { kind: "found" };

export interface Pairs {
  document: OpenDocument;
  points: readonly Pair[];
  known: Known;
}

type Answer = Pick<Outcome, "status" | "pareto" | "pareto_complete">;

/** A plan may be proved the best while there are pairs that were not met. */
export const hasAllPairs = ({ status, pareto_complete }: Answer): boolean =>
  (status === "optimal" || status === "infeasible") && pareto_complete !== false;

/** The pairs of two searches, each with its shorter plan, in the order of the core. */
export function merged(one: readonly Pair[], other: readonly Pair[]): Pair[] {
  const found = new Map<string, Pair>();
  for (const pair of [...one, ...other]) {
    const key = `${pair.adversarial},${pair.cooperative}`;
    const known = found.get(key);
    if (known === undefined || pair.plan.length < known.plan.length) found.set(key, pair);
  }
  return [...found.values()].sort((a, b) => a.adversarial - b.adversarial || a.cooperative - b.cooperative);
}

/** The length of the shortest plan among them; 0 where there is none. */
export const shortest = (points: readonly Pair[]): number =>
  points.length === 0 ? 0 : Math.min(...points.map(({ plan }) => plan.length));
