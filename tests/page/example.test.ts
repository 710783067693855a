// The page as it opens: the example, solved, drawn as the core says, with nothing fetched from elsewhere.
import assert from "node:assert/strict";
import { test } from "node:test";
import { visit } from "./support/browser.js";
import { example, solve } from "./support/core.js";
import { assertDrawn, attribute, drawn, press, slider, statusIs, stepIs } from "./support/playground.js";
import { address } from "./support/site.js";

const { outcome, trace } = solve(example, { solver: "exact", horizon: "any" });
const last = trace.steps.length - 1;

test("the example is worth showing", () => {
  assert.equal(outcome.status, "optimal");
  assert(Number(outcome.goal_difference) >= 0.5);
});

test("the page solves its example and shows the plan from its first step to its end", () =>
  visit(async ({ page, requests }) => {
    await statusIs(page, "optimal");
    assert.equal(await attribute(page, "data-gd"), String(outcome.goal_difference));
    assert.equal(await attribute(page, "data-step"), "0");
    assertDrawn(await drawn(page), trace.steps[0] ?? assert.fail(), "G1");
    await press(page, "Last step");
    await stepIs(page, last);
    assertDrawn(await drawn(page), trace.steps[last] ?? assert.fail(), "G1");
    const goals = trace.steps[last]?.goals;
    await page
      .getByText(`(${goals?.adversarial.length} for the enemy − ${goals?.cooperative.length} for the friend) ÷ (4 − 1)`)
      .waitFor();
    assert(
      requests.every((request) => request.startsWith(address)),
      `asked elsewhere: ${requests.join(" ")}`,
    );
  }));

test("every board has every cell, and only walls lack a place to be", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    for (const board of ["actor", "adversarial", "cooperative"]) {
      assert.equal(await page.locator(`[data-board="${board}"] [data-cell]`).count(), 64);
    }
    assert.equal(await page.locator('[data-board="actor"] [data-believed]').count(), 0);
    assert.equal(await page.locator(".wall[data-believed]").count(), 0);
  }));

test("each step is drawn as the core's trace has it", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    for (const [index, step] of trace.steps.entries()) {
      await slider(page).fill(String(index));
      await stepIs(page, index);
      assertDrawn(await drawn(page), step, "G1");
    }
  }));

test("buttons, Home and End walk through the steps", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await press(page, "Last step");
    await stepIs(page, last);
    await press(page, "First step");
    await stepIs(page, 0);
    await press(page, "Forward one step");
    await stepIs(page, 1);
    await page.keyboard.press("End");
    await stepIs(page, last);
    await page.keyboard.press("Home");
    await stepIs(page, 0);
    await slider(page).press("End");
    await stepIs(page, last);
    await slider(page).press("ArrowLeft");
    await stepIs(page, last - 1);
    await press(page, "Back one step");
    await stepIs(page, last - 2);
    await page.locator("[aria-live=polite]", { hasText: `Step ${last - 2}, ` }).waitFor({ state: "attached" });
  }));

test("playing goes on to the last step and stops there", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await slider(page).fill(String(last - 2));
    await press(page, "Play");
    await page.getByRole("button", { name: "Pause" }).waitFor();
    await stepIs(page, last);
    await page.getByRole("button", { name: "Play" }).waitFor();
  }));
