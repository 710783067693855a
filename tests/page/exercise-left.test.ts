// The problem of an exercise, opened without its question: what is locked, also after a reload, and the way back.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import type { GridworldDocument } from "../../www/src/problem/types.js";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { exerciseText, give, solved } from "./support/exercises.js";
import { dragMouse } from "./support/hands.js";
import { addressHolds } from "./support/links.js";
import { openTab, press, useDocument } from "./support/playground.js";

const { vary: _, ...block } = JSON.parse(exerciseText("01-possible-goals")).exercise;
const text = (lock: unknown, attempts = block.attempts) =>
  JSON.stringify({ ...JSON.parse(exerciseText("01-possible-goals")), exercise: { ...block, attempts, lock } });
/** The right answer. */
const { choices, form } = solved("01-possible-goals");
const right = choices.map((choice) => String(form.choices[choice]));
const locked = text(["walls", "observers"]);

test("what is locked stays locked after a reload, and a button leads back to the question with its attempts", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await give(page, locked);
    await page.getByRole("button", { name: /^Show a hint/ }).click();
    await page.getByLabel("G1", { exact: true }).check();
    await press(page, "Check the answer");
    await page.getByText("2 attempts left.").waitFor();
    await page.getByLabel("G2", { exact: true }).check();
    const code = await page.getByLabel("Answer code").inputValue();
    await press(page, "Open the problem in the playground");
    await page.locator("[data-board=actor]").waitFor();
    await page.getByText("Locked in it: walls, observers.").waitFor();
    await assertNoBarrier(page, "the problem of a question");
    // Nothing of the problem that was open before is behind this one.
    assert.equal(await page.getByRole("button", { name: "Undo", exact: true }).getAttribute("aria-disabled"), "true");
    await addressHolds(page, ({ question }) => question !== undefined);
    await page.reload();
    await page.getByText("Locked in it: walls, observers.").waitFor();
    const documentOf = () =>
      page.locator("mo-copp-playground").evaluate((element) => (element as MoCoppPlayground).document);
    const before = (await documentOf()) as GridworldDocument;
    const free = [...Array(before.width).keys()].find(
      (column) =>
        ![before.start, ...(before.walls ?? []), ...before.goals.map(({ cell }) => cell)].some(
          (cell) => String(cell) === `${column},0`,
        ),
    );
    const walls = page.getByRole("button", { name: "Walls", exact: true });
    const carried = before.walls?.[0] ?? assert.fail("a wall is needed");
    const carry = () => dragMouse(page, "actor", [carried, [free ?? 0, 0]]);
    assert.equal(await walls.getAttribute("aria-disabled"), "true");
    await carry();
    const refused = page.getByText("“walls” stays as the exercise has it: this part of the problem is locked.").first();
    await refused.waitFor();
    assert.deepEqual(await documentOf(), before);
    // What is not locked may be edited and undone; the lock stays with it.
    await openTab(page, "Edit");
    await page.getByLabel("Rows", { exact: true }).fill(String(before.height + 1));
    await page.getByLabel("Rows", { exact: true }).press("Enter");
    await addressHolds(page, ({ document }) => JSON.parse(String(document)).height === before.height + 1);
    await page.reload();
    await page.getByText("Locked in it: walls, observers.").waitFor();
    assert.equal(await walls.getAttribute("aria-disabled"), "true");
    await carry();
    await refused.waitFor();
    await press(page, "Back to the question");
    await page.getByText("2 attempts left.").waitFor();
    assert.equal(await page.locator(".hints li").count(), 1);
    assert.equal(await page.getByLabel("G2", { exact: true }).isChecked(), true);
    assert.equal(await page.getByLabel("Answer code").inputValue(), code);
    assert.equal(await page.getByRole("button", { name: "Back to the question" }).count(), 0);
  }));

/** Nothing that a solver finds is there, in sight or told to the page. */
async function assertClosed(page: Page): Promise<void> {
  await page.getByText("Solvers and best values are kept back until the question is answered.").waitFor();
  await page.locator("mo-copp-playground[data-status=idle]").waitFor();
  const tabs = await page.getByRole("tablist", { name: "Workbench" }).getByRole("tab").allTextContents();
  assert.deepEqual(tabs, ["Edit", "Play", "Document"]);
  assert.equal(await page.getByText(/Best possible|Best goal difference|this plan:/).count(), 0, "a best value");
  assert.equal(await page.locator("mo-copp-playground").getAttribute("data-gd"), null, "a goal difference");
  const told = await page.locator("mo-copp-playground").evaluate(async (element) => {
    const playground = element as MoCoppPlayground;
    const refused = await playground.solve({ solver: "exact" }).then(
      () => "solved",
      (error: Error) => error.message,
    );
    return { refused, plan: playground.state?.plan ?? null, outcomes: (window as unknown as Outcomes).outcomes };
  });
  assert.match(told.refused, /^The solvers are closed until the question/);
  assert.equal(told.plan, null, "the state holds no plan");
  assert.deepEqual(told.outcomes, [], "no outcome is told");
}

interface Outcomes {
  outcomes: string[];
}

/** From here on. */
const listen = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const heard = window as unknown as Outcomes;
    heard.outcomes = [];
    document.addEventListener("mo-copp-outcome", (event) => heard.outcomes.push(event.type));
  });

const attemptsOf = (question: unknown) => (question as { answer?: { attempts: number } } | undefined)?.answer?.attempts;

async function leave(page: Page): Promise<void> {
  await press(page, "Open the problem in the playground");
  await page.getByText("Locked in it: walls, observers.").waitFor();
}

test("where parts are locked, no solver and no best value is shown until the question is answered rightly", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await give(page, locked);
    await page.getByLabel("G1", { exact: true }).check();
    await press(page, "Check the answer");
    await page.getByText("Not right.").waitFor();
    await listen(page);
    await leave(page);
    await assertClosed(page);
    await assertNoBarrier(page, "a problem whose solvers are closed");
    // A walk of one's own is shown, and not how good the best one is; what the enemy guesses about is a solver's plan.
    await openTab(page, "Play");
    assert.equal(await page.getByRole("button", { name: "Start guessing" }).count(), 0, "a guess");
    await press(page, "Take over");
    await page.locator(".walkable:focus").waitFor();
    for (const [index, key] of ["ArrowLeft", "ArrowLeft", "ArrowUp", "ArrowUp"].entries()) {
      await page.keyboard.press(key);
      await page.locator(`mo-copp-playground[data-step="${index + 1}"]`).waitFor();
    }
    await press(page, "Stop walking");
    // An edit is solved no more than the problem itself, and neither is what a reload or undo brings back.
    const rows = JSON.parse(locked).height;
    await openTab(page, "Edit");
    await page.getByLabel("Rows", { exact: true }).fill(String(rows + 1));
    await page.getByLabel("Rows", { exact: true }).press("Enter");
    await addressHolds(page, ({ document }) => JSON.parse(String(document)).height === rows + 1);
    await assertClosed(page);
    await press(page, "Undo");
    await addressHolds(page, ({ document }) => JSON.parse(String(document)).height === rows);
    await assertClosed(page);
    await page.reload();
    await page.getByText("Locked in it: walls, observers.").waitFor();
    await listen(page);
    await assertClosed(page);
    // A right answer opens them, also after a reload.
    await press(page, "Back to the question");
    await page.getByText("Not right.").waitFor();
    for (const choice of form.choices.map(String))
      await page.getByLabel(choice, { exact: true }).setChecked(right.includes(choice));
    await press(page, "Check the answer");
    await page.getByText("Right.", { exact: true }).waitFor();
    await leave(page);
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await page
      .getByText(/^Best possible/)
      .first()
      .waitFor();
    await addressHolds(page, ({ question }) => attemptsOf(question) === 2);
    await page.reload();
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    assert.equal(await page.getByText("Solvers and best values are kept back").count(), 0, "the solvers are open");
  }));

test("the solvers are open where no attempt is left", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await give(page, text(["walls", "observers"], 1));
    await page.getByLabel("G1", { exact: true }).check();
    await press(page, "Check the answer");
    await page.getByText("No attempts left.").waitFor();
    await leave(page);
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
  }));

test("a problem that is no question's is free again, and undo leads from it to no other", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await give(page, text(false));
    await press(page, "Open the problem in the playground");
    await page.getByText("This is the problem of a question.").waitFor();
    // As text the problem stays the question's, whatever exercise the text holds.
    const { exercise: _, ...problem } = JSON.parse(locked);
    await useDocument(page, JSON.stringify({ ...problem, height: problem.height + 1, exercise: { kind: "best" } }));
    await addressHolds(page, ({ document }) => JSON.parse(String(document)).height === problem.height + 1);
    await page.getByRole("button", { name: "Back to the question" }).waitFor();
    await press(page, "Undo");
    await addressHolds(page, ({ document }) => JSON.parse(String(document)).height === problem.height);
    await give(page, JSON.stringify({ ...problem, walls: [] }));
    await page.getByRole("button", { name: "Back to the question" }).waitFor({ state: "detached" });
    assert.equal(await page.getByRole("button", { name: "Undo", exact: true }).getAttribute("aria-disabled"), "true");
  }));
