// The problem of a question for the true goal: it is opened with the goal that was found, and not before.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { exerciseText, give } from "./support/exercises.js";
import { addressHolds } from "./support/links.js";
import { openTab, press } from "./support/playground.js";

const found = "G1";
const document = JSON.parse(exerciseText("03-guess"));
const { vary: _, ...block } = document.exercise;
/** The first candidate, which stands for the true goal until that is found, is another one. */
const goals = [...document.goals].reverse();
const [standIn] = goals.map(({ name }: { name: string }) => name);
const guess = (lock: unknown = false, attempts = block.attempts) =>
  JSON.stringify({ ...document, goals, exercise: { ...block, attempts, lock } });

const words = "The problem can be opened once its goal is found.";
const open = (page: Page) => page.getByRole("button", { name: "Open the problem in the playground" });

async function answer(page: Page, goal: string): Promise<void> {
  await page.getByLabel(goal, { exact: true }).check();
  await press(page, "Check the answer");
  await page.locator(`[data-verdict=${goal === found ? "right" : "wrong"}]`).waitFor();
}

async function asked(page: Page, text: string): Promise<void> {
  await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
  await give(page, text);
  await page.getByText(words).waitFor();
}

test("a guess is opened once its goal is found, with that goal as the true one", () =>
  visit(async ({ page }) => {
    await asked(page, guess());
    assert.equal(await open(page).count(), 0, "a way to the problem before an answer");
    assert.notEqual(standIn, found);
    await answer(page, String(standIn));
    await page.getByText(words).waitFor();
    assert.equal(await open(page).count(), 0, "a way to the problem after a wrong answer");
    await assertNoBarrier(page, "a guess that is not found");
    await answer(page, found);
    assert.equal(await page.getByText(words).count(), 0, "the words after the right answer");
    // What is chosen beside the answer that was checked is no other goal of the problem.
    await page.getByLabel(String(standIn), { exact: true }).check();
    await press(page, "Open the problem in the playground");
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    const shown = async () => {
      const state = await page.locator("mo-copp-playground").evaluate((node) => (node as MoCoppPlayground).state);
      assert.equal(JSON.parse(String(state?.document)).true_goal, found, "the true goal of the state");
      const marked = page.locator("[data-board=actor] [data-true-goal]");
      assert.equal(await marked.getAttribute("data-goal"), found, "the true goal of the board");
    };
    await shown();
    await openTab(page, "Edit");
    const radios = page.getByRole("group", { name: "Candidate goals" }).getByRole("radio");
    await radios.first().waitFor();
    const chosen = await radios.evaluateAll((all) => all.map((radio) => (radio as HTMLInputElement).checked));
    assert.deepEqual(
      chosen,
      goals.map(({ name }: { name: string }) => name === found),
    );
    await addressHolds(page, ({ question }) => question !== undefined);
    await page.reload();
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await shown();
    await press(page, "Back to the question");
    await page.getByText("No attempts left.").waitFor();
    await open(page).waitFor();
  }));

test("where no attempt is left the goal is not found, and nothing is promised", () =>
  visit(async ({ page }) => {
    await asked(page, guess(["walls"], 1));
    await answer(page, String(standIn));
    await page.getByText("No attempts left.").waitFor();
    assert.equal(await page.getByText(words).count(), 0, "a promise");
    assert.equal(await open(page).count(), 0, "a way to the problem");
  }));

for (const lock of [[], ["walls"]])
  test(`a state whose guess is not answered rightly asks the question again, ${lock.length} parts locked`, () =>
    visit(async ({ page }) => {
      await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
      const { exercise: _, ...problem } = JSON.parse(guess(lock, 1));
      // The last attempt is made, and the answer is said to be worth something.
      const wrong = { choices: [0], attempts: 1, hints: 1, score: 1 };
      const state = {
        ...{
          document: JSON.stringify({ ...problem, true_goal: standIn }),
          form: {},
          step: 0,
          tab: "Edit",
          mode: "plan",
        },
        question: { document: guess(lock, 1), answer: { ...wrong, checked: wrong }, locked: lock },
      };
      await page.locator("mo-copp-playground").evaluate((node, text) => {
        (node as MoCoppPlayground).state = JSON.parse(text);
      }, JSON.stringify(state));
      await page.locator("[data-verdict=wrong]").waitFor();
      await page.getByText("No attempts left.").waitFor();
      assert.equal(await page.locator(".hints li").count(), 1);
      assert.equal(await page.getByLabel(String(standIn), { exact: true }).isChecked(), true);
      assert.equal(await page.locator("[data-true-goal]").count(), 0, "a true goal in sight");
      await addressHolds(page, ({ answer, question }) => answer !== undefined && question === undefined);
    }));
