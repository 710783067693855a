// What the trade-off says: nothing that is not known.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { LengthPoint } from "../../www/src/core.js";
import { lengthsInWords, pairsInWords } from "../../www/src/solve/tradeoff/words.js";
import { hasAllPairs, merged, type Pair } from "../../www/src/state/pairs.js";

const plan = (moves: number) => Array.from({ length: moves }, () => "east");
const pair = (adversarial: number, cooperative: number, moves: number): Pair => ({
  ...{ adversarial, cooperative },
  plan: plan(moves),
});
const three = [pair(1, 1, 4), pair(2, 1, 6), pair(3, 1, 30)];

test("what was found until a limit is at least, and what is not known is said", () => {
  const words = (points: Pair[], known: Parameters<typeof pairsInWords>[0]["known"]) =>
    pairsInWords({ points, known }, 3);
  assert.equal(
    words(three, { kind: "found" }),
    "At least 3 of 9 pairs can be reached, by the plans that were found until the search was stopped. Whether others can be is not known.",
  );
  assert.equal(
    words(three.slice(0, 2), { kind: "up to", moves: 6 }),
    "At least 2 of 9 pairs can be reached, by plans of at most 6 moves. Whether longer plans reach others is not known.",
  );
  assert.equal(
    words(three, { kind: "up to", moves: 6 }),
    "At least 3 of 9 pairs can be reached, 2 by plans of at most 6 moves, 1 by longer ones. Whether longer plans reach others is not known.",
  );
  assert.equal(
    words(three, { kind: "all" }),
    "3 of 9 pairs can be reached, by plans of every length. Up and to the left is better.",
  );
  const all = [1, 2, 3].flatMap((enemy) => [1, 2, 3].map((friend) => pair(enemy, friend, 5)));
  assert.equal(words(all, { kind: "found" }), "9 of 9 pairs can be reached. Up and to the left is better.");
  assert.equal(words([], { kind: "all" }), "No plan reaches the true goal.");
  assert.equal(words([], { kind: "found" }), "Not known: no plan was found until the search was stopped.");
  assert.equal(
    words([], { kind: "up to", moves: 1 }),
    "No plan of at most 1 move reaches the true goal. Whether a longer one does is not known.",
  );
});

test("a search that was stopped has not all pairs, whatever it proved of the best plan", () => {
  assert.equal(hasAllPairs({ status: "optimal", pareto: three }), true);
  assert.equal(hasAllPairs({ status: "infeasible" }), true);
  assert.equal(hasAllPairs({ status: "optimal", pareto: three, pareto_complete: false }), false);
  assert.equal(hasAllPairs({ status: "feasible", pareto: three }), false);
});

test("pairs that either of two searches found are kept, with the shorter plan", () => {
  assert.deepEqual(merged([pair(3, 1, 30), pair(1, 1, 9)], [pair(1, 1, 4), pair(2, 2, 5)]), [
    pair(1, 1, 4),
    pair(2, 2, 5),
    pair(3, 1, 30),
  ]);
});

test("of lengths that were not looked at nothing is said but that", () => {
  const none = (length: number): LengthPoint => ({
    ...{ length, adversarial: null, cooperative: null, goal_difference: null, plan: null },
  });
  const some = (length: number, goal_difference: number): LengthPoint => ({
    ...{ length, adversarial: 2, cooperative: 1, goal_difference, plan: plan(length) },
  });
  assert.equal(
    lengthsInWords([], false, ""),
    "Not known: the search was stopped before the first length was looked at.",
  );
  assert.equal(
    lengthsInWords([none(0), none(1)], false, " within the bounds"),
    "No plan of at most 1 move within the bounds. Proved up to 1 move; longer plans are not known.",
  );
  assert.equal(
    lengthsInWords([none(0), some(1, 0), some(2, 0.5)], true, ""),
    "The shortest plan has 1 move; the best here, 1/2, needs 2 moves.",
  );
  assert.equal(
    lengthsInWords([some(0, 0.5)], true, ""),
    "The shortest plan has 0 moves; the best here, 1/2, is one of them.",
  );
});
