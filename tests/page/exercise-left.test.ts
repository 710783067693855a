// The problem of an exercise, opened without its question: what is locked, also after a reload, and the way back.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import type { GridworldDocument } from "../../www/src/problem/types.js";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { exerciseText, give } from "./support/exercises.js";
import { addressHolds } from "./support/links.js";
import { openTab, press, useDocument } from "./support/playground.js";

const { vary: _, ...block } = JSON.parse(exerciseText("01-possible-goals")).exercise;
const text = (lock: unknown) =>
  JSON.stringify({ ...JSON.parse(exerciseText("01-possible-goals")), exercise: { ...block, lock } });
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
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    const documentOf = () =>
      page.locator("mo-copp-playground").evaluate((element) => (element as MoCoppPlayground).document);
    const before = (await documentOf()) as GridworldDocument;
    const free = [...Array(before.width).keys()].find(
      (column) =>
        ![before.start, ...(before.walls ?? []), ...before.goals.map(({ cell }) => cell)].some(
          (cell) => String(cell) === `${column},0`,
        ),
    );
    await press(page, "Walls");
    await page.locator(`[data-board=actor] [data-cell="${free},0"]`).click();
    const refused = page.getByText("“walls” stays as the exercise has it: this part of the problem is locked.").first();
    await refused.waitFor();
    assert.deepEqual(await documentOf(), before);
    // What is not locked may be edited and undone; the lock stays with it.
    await openTab(page, "Edit");
    await page.getByLabel("Rows", { exact: true }).fill(String(before.height + 1));
    await page.getByLabel("Rows", { exact: true }).press("Enter");
    await addressHolds(page, ({ document }) => JSON.parse(String(document)).height === before.height + 1);
    await page.reload();
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await press(page, "Walls");
    await page.locator(`[data-board=actor] [data-cell="${free},0"]`).click();
    await refused.waitFor();
    await press(page, "Back to the question");
    await page.getByText("2 attempts left.").waitFor();
    assert.equal(await page.locator(".hints li").count(), 1);
    assert.equal(await page.getByLabel("G2", { exact: true }).isChecked(), true);
    assert.equal(await page.getByLabel("Answer code").inputValue(), code);
    assert.equal(await page.getByRole("button", { name: "Back to the question" }).count(), 0);
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
