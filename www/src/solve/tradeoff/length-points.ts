// The best of every length as it is shown: in the picture and in its table.
import type { LengthPoint } from "../../core.js";
import type { Boards } from "../../state/boards.js";
import type { Plans } from "../../state/plans.js";
import type { Timeline } from "../../state/timeline.js";
import { counted, differenceText } from "../../view/numbers.js";

export interface LengthPointStores {
  boards: Boards;
  timeline: Timeline;
  plans: Plans;
}

type Feasible = Extract<LengthPoint, { plan: string[] }>;

export interface ShownLength extends Feasible {
  /** No other length that is shown has a larger goal difference. */
  best: boolean;
  shown: boolean;
  first: boolean;
  name: string;
  choose: () => void;
}

export const isFeasible = (point: LengthPoint): point is Feasible => point.plan !== null;

export function lengthPoints(playground: LengthPointStores, lengths: readonly LengthPoint[]): ShownLength[] {
  const feasible = lengths.filter(isFeasible);
  const most = Math.max(...feasible.map((point) => point.goal_difference));
  const value = playground.boards.difference.value;
  const moves = playground.timeline.lastStep.value;
  const points = feasible.map((point): ShownLength => {
    const { length, plan, goal_difference, adversarial, cooperative } = point;
    const best = goal_difference === most;
    return {
      ...point,
      best,
      shown: value !== null && length === moves && Math.abs(value - goal_difference) < 1e-9,
      first: false,
      name: `${counted(length, "move")}: goal difference ${differenceText(goal_difference)}, ${adversarial} possible for the enemy, ${cooperative} for the friend${best ? ", the best" : ""}`,
      choose: () => void playground.plans.show(plan, `the best plan of ${counted(length, "move")}`),
    };
  });
  const first = points.find(({ shown }) => shown) ?? points.find(({ best }) => best) ?? points[0];
  if (first !== undefined) first.first = true;
  return points;
}
