// What was tried of an exercise: attempts and hints that no button of the page takes back, and a score that no state says.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { Exercise, seedOf } from "./support/core.js";
import { exerciseText, give, hear, heardOn, openExercise, solved } from "./support/exercises.js";
import { addressHolds } from "./support/links.js";
import { press } from "./support/playground.js";

type Kept = Partial<NonNullable<MoCoppPlayground["state"]>>;

const goals = "01-possible-goals";

test("no score and no code of a state counts: the core judges the answer again", () =>
  visit(async ({ page }) => {
    await openExercise(page, goals);
    await hear(page);
    const element = page.locator("mo-copp-playground");
    const set = (checked: object, choices: number[]) =>
      element.evaluate(
        (element, [checked, choices]) => {
          const playground = element as MoCoppPlayground;
          const answer = { choices, attempts: 1, hints: 1, name: "", checked };
          playground.state = { ...playground.state, answer } as typeof playground.state;
        },
        [checked, choices] as const,
      );
    const exercise = new Exercise(exerciseText(goals), 0);
    const wrong = exercise.check(Uint32Array.from([0]), 1, 1).code;
    // As states of before had it, and as they are now.
    for (const forged of [
      { code: "FORGED", score: 1 },
      { code: "FORGED", score: 1, choices: [0], attempts: 1, hints: 1 },
    ]) {
      await set(forged, [0]);
      await page.locator("[data-verdict=wrong]").waitFor();
      assert.equal(await page.getByLabel("Answer code").inputValue(), wrong);
      assert.equal(await element.getAttribute("data-exercise"), "wrong");
    }
    const { choices } = solved(goals);
    await set({ choices, attempts: 1, hints: 1 }, choices);
    await page.locator("[data-verdict=right]").waitFor();
    const right = exercise.check(Uint32Array.from(choices), 1, 1).code;
    const heard = (await heardOn(page)).map(([type, { code, score }]) => [type, code, score]);
    assert.deepEqual(
      [...new Set(heard.map((one) => JSON.stringify(one)))].map((one) => JSON.parse(one)),
      [
        ["mo-copp-answer", wrong, 0],
        ["mo-copp-score", null, 0],
        ["mo-copp-answer", right, 1],
        ["mo-copp-score", null, 1],
      ],
    );
    // What is kept says neither.
    const kept = JSON.stringify(await element.evaluate((element) => (element as MoCoppPlayground).state?.answer));
    assert.doesNotMatch(kept, /score|code/);
    // Another answer was begun before the page is loaded again: what counts is the one that was checked.
    await page.getByLabel("G1", { exact: true }).click();
    const lengths = ({ answer }: Kept) => [answer?.choices.length, answer?.checked?.choices.length];
    const begun = String([choices.length + (choices.includes(0) ? -1 : 1), choices.length]);
    await addressHolds(page, (state) => String(lengths(state)) === begun);
    await page.reload();
    await page.locator("mo-copp-playground[data-exercise=right]").waitFor();
    assert.equal(await page.getByLabel("Answer code").inputValue(), right);
    assert.equal(await page.locator("[data-verdict]").count(), 0);
  }));

test("an answer of a state that no question takes is left out", () =>
  visit(async ({ page }) => {
    await openExercise(page, "05-start");
    await page.locator("mo-copp-playground").evaluate((element) => {
      const playground = element as MoCoppPlayground;
      const answer = {
        choices: [0, 1, 9999],
        attempts: 1,
        hints: 0,
        name: "",
        checked: { choices: [9999], attempts: 1, hints: 0 },
      };
      playground.state = { ...playground.state, answer } as typeof playground.state;
    });
    await page.locator(".cell[aria-pressed=true]").first().waitFor();
    assert.equal(await page.locator(".cell[aria-pressed=true]").count(), 1);
    await page.locator("mo-copp-playground[data-exercise=open]").waitFor();
  }));

test("attempts and hints stay, whatever name is asked for and in whatever order", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await give(page, exerciseText(goals));
    const name = page.getByLabel("Your name or number");
    const call = async (who: string) => {
      await name.fill(who);
      await press(page, "Show my question");
      await page.locator(`.exercise[data-seed="${seedOf(who)}"]`).waitFor();
      await page.getByText(`This is the question of ${who}.`).waitFor();
    };
    await call("Ada");
    await page.getByRole("button", { name: /^Show a hint/ }).click();
    const check = page.getByRole("button", { name: "Check the answer" });
    await check.click();
    await check.click();
    await page.getByText("2 attempts left.").waitFor();
    // The same name, by the button and by the key.
    await press(page, "Show my question");
    await name.press("Enter");
    await page.getByText("2 attempts left.").waitFor();
    assert.equal(await page.locator(".hints li").count(), 1);
    const code = await page.getByLabel("Answer code").inputValue();
    // Another one, and back.
    await call("Grace");
    await page.getByText("3 attempts left.").waitFor();
    assert.equal(await page.locator(".hints li").count(), 0);
    await page.locator(".choices input").first().check();
    await press(page, "Without a name");
    await page.getByText("This is the question without a name.").waitFor();
    await page.getByRole("button", { name: /^Show a hint/ }).click();
    await press(page, "Without a name");
    assert.equal(await page.locator(".hints li").count(), 1);
    await call("Ada");
    await page.getByText("2 attempts left.").waitFor();
    assert.equal(await page.getByLabel("Answer code").inputValue(), code);
    // By way of another name and a reload, too.
    await call("Grace");
    await addressHolds(page, ({ answer }: Kept) => answer?.name === "Grace");
    await page.reload();
    await page.getByText("This is the question of Grace.").waitFor();
    assert.equal(await page.locator(".choices input").first().isChecked(), true);
    await call("Ada");
    await page.getByText("2 attempts left.").waitFor();
    assert.equal(await page.getByLabel("Answer code").inputValue(), code);
    assert.equal(await page.locator(".hints li").count(), 1);
    // The page that opens the exercise anew begins anew.
    await give(page, exerciseText(goals));
    await page.locator("#exercise-question").waitFor({ state: "detached" });
    await call("Ada");
    await page.getByText("3 attempts left.").waitFor();
  }));
