// The reachable pairs as they are shown: in the picture and in its table.
import type { SolveOptions } from "../../core.js";
import type { Boards } from "../../state/boards.js";
import type { Pair } from "../../state/pairs.js";
import type { Plans } from "../../state/plans.js";
import type { Timeline } from "../../state/timeline.js";
import { counted, differenceText } from "../../view/numbers.js";

export interface PairPointStores {
  boards: Boards;
  timeline: Timeline;
  plans: Plans;
}

export type Bounds = Pick<SolveOptions, "k" | "j">;

export interface PairPoint extends Pair {
  difference: number;
  /** None within the bounds has a larger goal difference. */
  best: boolean;
  /** It breaks a bound. */
  outside: boolean;
  /** The plan on the boards ends here. */
  shown: boolean;
  first: boolean;
  name: string;
  choose: () => void;
}

export function pairPoints(
  playground: PairPointStores,
  pairs: readonly Pair[],
  goals: number,
  bounds: Bounds,
): PairPoint[] {
  const breaks = ({ adversarial, cooperative }: Pair) =>
    (bounds.k !== undefined && adversarial < bounds.k) || (bounds.j !== undefined && cooperative > bounds.j);
  const ahead = ({ adversarial, cooperative }: Pair) => adversarial - cooperative;
  const most = Math.max(...pairs.filter((pair) => !breaks(pair)).map(ahead));
  const end =
    playground.boards.difference.value === null ? undefined : playground.timeline.trace.value?.steps.at(-1)?.goals;
  const points = pairs.map((pair): PairPoint => {
    const { adversarial, cooperative, plan } = pair;
    const outside = breaks(pair);
    const best = !outside && ahead(pair) === most;
    const value = ahead(pair) / (goals - 1);
    return {
      ...pair,
      difference: value,
      best,
      outside,
      shown: end?.adversarial.length === adversarial && end.cooperative.length === cooperative,
      first: false,
      name: `${adversarial} possible for the enemy, ${cooperative} for the friend: goal difference ${differenceText(value)} in ${counted(plan.length, "move")}${outside ? ", outside the bounds" : best ? ", the best" : ""}`,
      choose: () =>
        void playground.plans.show(
          plan,
          `a plan that leaves ${adversarial} to the enemy, ${cooperative} to the friend`,
        ),
    };
  });
  const first = points.find(({ shown }) => shown) ?? points.find(({ best }) => best) ?? points[0];
  if (first !== undefined) first.first = true;
  return points;
}
