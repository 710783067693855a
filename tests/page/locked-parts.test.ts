// A problem that is opened from its question: what is locked looks locked, and what the question hides stays hidden.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { exerciseText, give } from "./support/exercises.js";
import { openTab, press } from "./support/playground.js";

const withLock = (name: string, lock: readonly string[]) => {
  const document = JSON.parse(exerciseText(name));
  const { vary: _, ...exercise } = document.exercise;
  return JSON.stringify({ ...document, exercise: { ...exercise, lock } });
};

test("parts that are locked are disabled with the reason, and no plan is promised", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await give(page, withLock("12-best", ["start", "goals", "true_goal", "observers"]));
    await press(page, "Open the problem in the playground");
    await page.getByText("Locked in it:").waitFor();
    const about = page.locator(".toolbar .about");
    assert.equal(
      await about.textContent(),
      "Drag a wall on the agent’s board. Locked by the exercise: start and goals stay as they are.",
    );
    const tool = (name: string) => page.locator(".toolbar .tools button", { hasText: name });
    for (const [name, disabled] of Object.entries({
      Move: "false",
      Walls: "false",
      "First belief": "true",
      Cameras: "true",
    }))
      assert.equal(await tool(name).getAttribute("aria-disabled"), disabled, name);
    assert.equal(await tool("Cameras").getAttribute("title"), "Locked by the exercise: observers stay as they are.");
    await openTab(page, "Edit");
    const goals = page.getByRole("group", { name: "Candidate goals" });
    await goals.getByText("Locked by the exercise: goals and true goal stay as they are.").waitFor();
    for (const control of await goals.locator("input, button").all()) assert.equal(await control.isDisabled(), true);
    const told = page.getByRole("group", { name: "What the enemy is told" });
    assert.equal(await told.getByLabel("Sensor").isDisabled(), true);
    assert.equal(await page.getByLabel("Rows", { exact: true }).isDisabled(), false);
    await assertNoBarrier(page, "locked parts");
  }));

test("what the question hides of beliefs stays hidden in its problem until it is answered", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await give(page, withLock("01-possible-goals", ["walls"]));
    await press(page, "Open the problem in the playground");
    await page.getByText("So is what the enemy and the friend believe.").waitFor();
    const seen = () =>
      page.evaluate(() => document.querySelectorAll("[data-board=adversarial], [data-board=cooperative]").length);
    assert.equal(await seen(), 0);
    // What is painted on these boards has no tool.
    const tools = page.locator(".toolbar .tools button");
    assert.deepEqual(await tools.evaluateAll((all) => all.map(({ textContent }) => textContent?.trim())), [
      "Move",
      "Walls",
    ]);
    assert.equal(
      await page.locator(".toolbar .about").textContent(),
      "Drag the start or a goal. Locked by the exercise: walls stay as they are.",
    );
    // Nor does the agent's board say what is possible for them: no mark, no word, no attribute, and none explained.
    const told = "[data-adversarial], [data-cooperative], .board .mark, .legend";
    assert.equal(await page.locator(told).count(), 0);
    const titles = await page.locator("[data-board=actor] .goal title").allTextContents();
    assert.deepEqual(
      titles.filter((title) => title.includes(":")),
      [],
    );
    assert(titles.length > 1, titles.join());
    const tabs = await page.getByRole("tablist", { name: "Workbench" }).getByRole("tab").allTextContents();
    assert.deepEqual(tabs, ["Edit", "Play", "Document"]);
    const drawn = (board: "actor" | "adversarial") =>
      page.locator("mo-copp-playground").evaluate(
        (node, board) =>
          (node as MoCoppPlayground).toSVG({ board }).then(
            () => "drawn",
            (error: Error) => error.message,
          ),
        board,
      );
    assert.match(await drawn("adversarial"), /^The question of this problem hides what observers believe/);
    assert.equal(await drawn("actor"), "drawn");
    await press(page, "Back to the question");
    for (const goal of ["G1", "G2"]) await page.getByLabel(goal, { exact: true }).check();
    await press(page, "Check the answer");
    await page.getByText("Right.", { exact: true }).waitFor();
    await press(page, "Open the problem in the playground");
    await page.locator("[data-board=adversarial]").waitFor();
    assert.equal(await tools.count(), 4);
    await page.locator("[data-board=actor] .goal[data-adversarial]").first().waitFor();
    assert.equal(await page.getByText("So is what the enemy and the friend believe.").count(), 0);
  }));
