// The trade-off as files: the pairs and the lengths that are shown, each with its plan.
import type { LengthPoint } from "../../core.js";
import type { Pairs } from "../../state/pairs.js";
import type { Lengths } from "../../state/tradeoff.js";
import type { Table } from "../../view/save-table.js";

/** `goals`: how many candidate goals there are; `problem`: what files of the problem are called. */
export function pairsFile({ points, known }: Pairs, goals: number, problem: string): Table {
  const rows = points.map(({ adversarial, cooperative, plan }) => ({
    ...{ adversarial, cooperative },
    goal_difference: (adversarial - cooperative) / (goals - 1),
    plan,
  }));
  return {
    name: `${problem}-pairs`,
    rows: () => [
      ["enemy goals", "friend goals", "goal difference", "moves", "plan"],
      ...rows.map((row) => [
        row.adversarial,
        row.cooperative,
        row.goal_difference,
        row.plan.length,
        row.plan.join(" "),
      ]),
    ],
    json: () => ({ known, pareto: rows }),
  };
}

export function lengthsFile({ points, bounds, complete }: Lengths, problem: string): Table {
  const cells = ({ length, goal_difference, adversarial, cooperative, plan }: LengthPoint) => [
    ...[length, goal_difference, adversarial, cooperative],
    plan?.join(" ") ?? null,
  ];
  return {
    name: `${problem}-lengths`,
    rows: () => [["moves", "goal difference", "enemy goals", "friend goals", "plan"], ...points.map(cells)],
    json: () => ({ bounds, complete, lengths: points }),
  };
}
