// What the two pictures of the trade-off show, in words: what was found until a limit is "at least", and what is not
// known is said.
import type { LengthPoint } from "../../core.js";
import type { Pairs } from "../../state/pairs.js";
import { counted, differenceText } from "../../view/numbers.js";
import { isFeasible } from "./length-points.js";

/** `goals`: how many candidate goals there are. */
export function pairsInWords({ points, known }: Pick<Pairs, "points" | "known">, goals: number): string {
  const reached = `${points.length} of ${goals * goals} pairs can be reached`;
  if (points.length === 0) return withoutPairs(known);
  if (known.kind === "all") return `${reached}, by plans of every length. Up and to the left is better.`;
  if (points.length === goals * goals) return `${reached}. Up and to the left is better.`;
  if (known.kind === "found") {
    return `At least ${reached}, by the plans that were found until the search was stopped. Whether others can be is not known.`;
  }
  const short = points.filter(({ plan }) => plan.length <= known.moves).length;
  const longer = points.length - short;
  const others = longer === 0 ? "" : `, ${longer} by longer ones`;
  return `At least ${reached}, ${longer === 0 ? "" : `${short} `}by plans of at most ${counted(known.moves, "move")}${others}. Whether longer plans reach others is not known.`;
}

function withoutPairs(known: Pairs["known"]): string {
  if (known.kind === "all") return "No plan reaches the true goal.";
  if (known.kind === "found") return "Not known: no plan was found until the search was stopped.";
  return `No plan of at most ${counted(known.moves, "move")} reaches the true goal. Whether a longer one does is not known.`;
}

/** `complete`: every length that was asked for was looked at; `within`: " within the bounds", or nothing. */
export function lengthsInWords(lengths: readonly LengthPoint[], complete: boolean, within: string): string {
  const last = lengths.at(-1)?.length;
  if (last === undefined) return "Not known: the search was stopped before the first length was looked at.";
  const feasible = lengths.filter(isFeasible);
  const [shortest] = feasible;
  const proved = complete ? "" : ` Proved up to ${counted(last, "move")}; longer plans are not known.`;
  if (shortest === undefined) return `No plan of at most ${counted(last, "move")}${within}.${proved}`;
  const best = feasible.reduce((one, other) => (other.goal_difference > one.goal_difference ? other : one));
  const needs = best === shortest ? "is one of them" : `needs ${counted(best.length, "move")}`;
  return `The shortest plan${within} has ${counted(shortest.length, "move")}; the best here, ${differenceText(best.goal_difference)}, ${needs}.${proved}`;
}
