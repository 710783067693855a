// Cutting a run into slices: the budget follows the time a slice takes, and a stop is obeyed between slices.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Progress } from "../../www/src/core.js";
import { firstBudget, nextBudget } from "../../www/src/worker/budget.js";
import { inSlices } from "../../www/src/worker/slices.js";

test("the budget settles where a slice takes about 20 ms", () => {
  for (const perUnit of [0.0001, 0.03, 5, 700]) {
    let budget = firstBudget;
    for (let slice = 0; slice < 40; slice += 1) budget = nextBudget(budget, budget * perUnit);
    const expected = Math.min(1_000_000, Math.max(1, 20 / perUnit));
    assert(budget >= expected / 1.5 - 1 && budget <= expected * 1.5 + 1, `${perUnit} ms a unit: ${budget}`);
  }
});

test("one slow slice does not throw the budget far off", () => {
  assert.equal(nextBudget(1000, 0), 4000);
  assert.equal(nextBudget(1000, 60_000), 250);
  assert.equal(nextBudget(1, 60_000), 1);
});

test("a run is advanced until it is finished or told to stop", async () => {
  let slices = 0;
  const run = { advance: () => ++slices >= 5, progress: () => ({}) as Progress };
  await inSlices(
    run,
    () => false,
    () => undefined,
  );
  assert.equal(slices, 5);
  await inSlices(
    run,
    () => true,
    () => undefined,
  );
  assert.equal(slices, 5);
});
