// Choosing a goal: until when it is possible for an observer, and which symbol ends that.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fate } from "../../www/src/state/goal-story.js";
import { visit } from "./support/browser.js";
import { example, solve } from "./support/core.js";
import { attribute, press, statusIs, stepIs } from "./support/playground.js";

const { trace } = solve(example, { solver: "exact" });

test("a goal ends where it is possible for the last time before", () => {
  for (const { name } of JSON.parse(example).goals) {
    for (const role of ["adversarial", "cooperative"] as const) {
      const end = fate(trace, name, role);
      const alive = trace.steps.map((step) => step.goals[role].includes(name));
      if (end.kind === "possible") assert(alive.at(-1));
      else if (end.kind === "never") assert(!alive.includes(true));
      else {
        assert(alive[end.step - 1] && !alive.slice(end.step).includes(true));
        assert.equal(end.symbol, trace.steps[end.step]?.symbols[role]);
      }
    }
  }
});

test("choosing a goal shows that step and says the symbol", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const ending = JSON.parse(example)
      .goals.map(({ name }: { name: string }) => ({ name, end: fate(trace, name, "cooperative") }))
      .find(({ end }: { end: { kind: string } }) => end.kind === "ends");
    assert(ending, "a goal of the example ends for the friend");
    await press(page, ending.name);
    await stepIs(page, ending.end.step);
    await page
      .getByText(
        `for the friend it is possible until step ${ending.end.step - 1}; “${ending.end.symbol}” at step ${ending.end.step} ends that`,
      )
      .waitFor();
    await press(page, "G1");
    await page
      .getByText("G1: for the enemy it is possible at the end; for the friend it is possible at the end.")
      .waitFor();
    assert.equal(await attribute(page, "data-step"), String(ending.end.step));
  }));
