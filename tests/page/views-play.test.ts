// The further domains: being the agent, being the enemy.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { visit } from "./support/browser.js";
import { openTab, press, statusIs, stepIs } from "./support/playground.js";
import { board, drop, open, switches } from "./support/views.js";

test("walking: the keys push the box, and one of many actions is found by its words", () =>
  open("box-pushing", async (page) => {
    await openTab(page, "Play");
    await press(page, "Take over");
    await page.locator(".walkable").focus();
    for (const [index, key] of ["ArrowUp", "ArrowLeft", "ArrowUp", "ArrowUp"].entries()) {
      await page.keyboard.press(key);
      await stepIs(page, index + 1);
    }
    await page.getByText("You: 0 in 4 actions.").waitFor();
    await drop(page, switches(Array.from({ length: 60 }, (_, index) => `lamp${index}`)));
    await board(page, "actor").locator("dt", { hasText: "up" }).waitFor();
    await openTab(page, "Play");
    await press(page, "Take over");
    const field = page.getByLabel("Find an action");
    await field.fill("lamp4 flip");
    const found = page.getByRole("list", { name: "What can be done now" }).getByRole("button");
    assert.deepEqual(await found.allInnerTexts(), [
      "flip lamp4",
      ...Array.from({ length: 10 }, (_, index) => `flip lamp4${index}`),
    ]);
    await press(page, "flip lamp4");
    await stepIs(page, 1);
    await board(page, "actor").locator("dd", { hasText: "lamp4" }).first().waitFor();
    assert.equal(await field.inputValue(), "");
  }));

test("guessing: nothing on the page shows what the enemy is not told", () =>
  open("blocks", async (page) => {
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.waitForSelector('mo-copp-playground[data-step="0"]');
    await page.getByText("Which goal is it after?").waitFor();
    assert.equal(await board(page, "actor").count(), 0);
    assert.equal(await board(page, "cooperative").count(), 0);
    assert.equal(await page.locator("[data-true-goal]").count(), 0);
    await board(page, "adversarial").waitFor();
  }));

test("a problem that is too large to be solved at once can be guessed at", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await drop(page, readFileSync(new URL("support/logistics-19.json", import.meta.url), "utf8"));
    await board(page, "actor").locator(".thing-box.package").nth(5).waitFor();
    await press(page, "Cancel");
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    assert.equal(await page.locator("[data-true-goal]").count(), 0);
  }));
