// How well the person did, from 0 to 1: in an exercise, whether the answer is right; in a guess, whether it was right; in a walk of one's own, how much of the best
// goal difference of its length it has. Null while nothing was tried to its end.
import type { Playground } from "../playground/playground.js";

export function scoreOf({ guess, walk, boards, exercise }: Playground): number | null {
  if (exercise.posed.value !== null) return exercise.score.value;
  const round = guess.round.value;
  if (round.kind === "over") return round.guess === round.goal ? 1 : 0;
  const verdict = walk.verdict.value;
  if (boards.mode.value !== "walk" || verdict.kind !== "compared") return null;
  const { difference, best } = verdict;
  return best.goal_difference === null ? null : share(difference, best.goal_difference);
}

/** What is reached of the best; where the best is no more than 0, only the best itself counts. */
function share(reached: number, best: number): number {
  if (reached >= best) return 1;
  return best > 0 ? Math.max(0, reached) / best : 0;
}
