// Being the agent and being the enemy.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { example, replay, solve } from "./support/core.js";
import { figure1, grid } from "./support/documents.js";
import {
  assertDrawn,
  attribute,
  drawn,
  openTab,
  press,
  slider,
  statusIs,
  stepIs,
  useDocument,
} from "./support/playground.js";

const arrows: Record<string, string> = {
  north: "ArrowUp",
  south: "ArrowDown",
  east: "ArrowRight",
  west: "ArrowLeft",
};

const guess = (page: Page, goal: string) =>
  page.locator(".play.guess").getByRole("button", { name: goal, exact: true }).click();

async function takeOver(page: Page): Promise<void> {
  await openTab(page, "Play");
  await press(page, "Take over");
  await stepIs(page, 0);
}

test("a walk by keys shows what both observers make of every step, and is compared with the best of its length", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const pairs = solve(example, { solver: "exact", pareto: true }).outcome.pareto ?? [];
    const worst = pairs.reduce((a, b) => (b.adversarial - b.cooperative < a.adversarial - a.cooperative ? b : a));
    const plan = worst.plan;
    const best = solve(example, { solver: "exact", horizon: plan.length }).outcome;
    await takeOver(page);
    // The keys work at once: the board has the focus.
    await page.waitForFunction(() => document.activeElement?.matches('[role="application"].walkable') ?? false);
    for (const [index, action] of plan.entries()) {
      await page.keyboard.press(arrows[action] ?? assert.fail());
      await stepIs(page, index + 1);
      assertDrawn(await drawn(page), replay(example, plan.slice(0, index + 1)).steps.at(-1) ?? assert.fail(), "G1");
    }
    const own = replay(example, plan).goal_difference;
    assert.equal(await attribute(page, "data-gd"), String(own));
    await page.getByText(`in ${plan.length} actions.`).waitFor();
    assert(Number(best.goal_difference) > own, "the example has something to learn from");
    await press(page, "Show it");
    await page.waitForSelector(`mo-copp-playground[data-gd="${best.goal_difference}"]`);
  }));

test("what can't be done is said, and nothing changes", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await takeOver(page);
    await page.getByRole("application", { name: /walk with the arrow keys/ }).press("ArrowDown");
    await page.getByText("You can't do “south” here.").waitFor();
    assert.equal(await attribute(page, "data-step"), "0");
    assert.equal(await page.getByRole("button", { name: "south", exact: true }).getAttribute("aria-disabled"), "true");
  }));

test("keys that come faster than the steps are all taken", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await takeOver(page);
    const board = page.getByRole("application", { name: /walk with the arrow keys/ });
    await board.focus();
    for (const key of ["ArrowUp", "ArrowUp", "ArrowUp", "ArrowRight", "ArrowRight"]) void page.keyboard.press(key);
    await stepIs(page, 5);
    await page.keyboard.press("Backspace");
    await stepIs(page, 4);
  }));

test("a walk goes on from the step shown, and ends when the person stops", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const before = await drawn(page);
    await takeOver(page);
    for (const action of ["north", "north"]) await press(page, action);
    await stepIs(page, 2);
    await press(page, "Back one step");
    await stepIs(page, 1);
    await press(page, "east");
    await page.getByText("You did east").waitFor();
    assertDrawn(await drawn(page), replay(example, ["north", "east"]).steps.at(-1) ?? assert.fail(), "G1");
    await press(page, "Take back a step");
    await stepIs(page, 1);
    await press(page, "Start over");
    await stepIs(page, 0);
    await press(page, "Stop walking");
    await page.getByRole("button", { name: "Take over" }).waitFor();
    assert.deepEqual(await drawn(page), before);
  }));

test("a finger walks to the cell it touches", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await takeOver(page);
      await page.locator('[data-board="actor"] [data-cell="0,6"]').tap();
      await stepIs(page, 1);
      // A cell farther away is not a step.
      await page.locator('[data-board="actor"] [data-cell="4,4"]').tap();
      await page.locator('[data-board="actor"] [data-cell="1,6"]').tap();
      await stepIs(page, 2);
      assertDrawn(await drawn(page), replay(example, ["north", "east"]).steps.at(-1) ?? assert.fail(), "G1");
    },
    { viewport: { width: 390, height: 844 }, hasTouch: true },
  ));

test("a delivery is driven by its actions", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, figure1);
    await page.locator("svg.delivery").first().waitFor();
    await takeOver(page);
    for (const action of ["load a2", "load a1", "deliver"]) await press(page, action);
    await page.getByText("You: 1 in 3 actions. No plan of that length does better.").waitFor();
    await page.getByText("There is nothing left to do.").waitFor();
    assert.equal(await attribute(page, "data-gd"), "1");
  }));

test("as the enemy one sees the enemy's board alone, guesses, and is told", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const before = await drawn(page);
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    assert.equal(await attribute(page, "data-gd"), null);
    for (let step = 0; step < 3; step += 1) {
      assert.equal(await page.locator("[data-true-goal], .stage .star, .goals .star").count(), 0);
      // Nothing is said of the friend, and not how long the way is before it is walked.
      assert.equal(await page.locator("[data-cooperative]").count(), 0);
      assert.equal(await page.locator('[data-board="adversarial"] title', { hasText: /friend|both|only/ }).count(), 0);
      assert.equal(await page.locator('[data-board="actor"], [data-board="cooperative"]').count(), 0);
      assert.equal(await page.locator(".panel.cooperative .symbols, .panel.actor .symbols").count(), 0);
      assert.equal(await page.locator(".panel.adversarial .symbols li").count(), step);
      assert.equal(await page.locator(".stepper .count").innerText(), `Step ${step}`);
      assert.equal(await slider(page).getAttribute("max"), String(step));
      await press(page, "Forward one step");
      await stepIs(page, step + 1);
    }
    for (const tab of ["Solve", "Document"]) {
      assert(await page.getByRole("tab", { name: tab, exact: true }).isDisabled());
    }
    await press(page, "Last step");
    await page.getByText("The agent has arrived.").waitFor();
    await guess(page, "G2");
    const verdict = (await page.locator(".play.guess [role=status]").textContent()) ?? "";
    assert.match(verdict, /Right: it was G2|No: it was G[134], not G2/);
    const goal = /it was (G\d)/.exec(verdict)?.[1] ?? assert.fail();
    const secret = JSON.stringify({ ...JSON.parse(example), true_goal: goal });
    const { trace } = solve(secret, { solver: "exact" });
    assertDrawn(await drawn(page), trace.steps.at(-1) ?? assert.fail(), goal);
    await page.getByText(/[01] of 1 right/).waitFor();
    await press(page, "Leave the game");
    await page.getByRole("button", { name: "Start guessing" }).waitFor();
    assert.deepEqual(await drawn(page), before);
  }));

test("after a guess nothing is said to be the open problem's plan", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.locator(".next button").first().click();
    await page.getByText("The boards now show the whole way.").waitFor();
    assert.equal(await page.locator('.plans [aria-pressed="true"]').count(), 0);
    assert.equal(await page.getByText(/^Best possible/).count(), 0);
    await press(page, "Leave the game");
    await page.getByText(/^Best possible/).waitFor();
    assert.equal(await page.locator('.plans [aria-pressed="true"]').count(), 1);
  }));

test("an edit ends the game", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    await guess(page, "G1");
    await useDocument(page, grid());
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 12);
    await openTab(page, "Play");
    await page.getByRole("button", { name: "Start guessing" }).waitFor();
    assert.equal(await page.locator('[data-board="actor"] [data-true-goal]').getAttribute("data-goal"), "G1");
  }));
