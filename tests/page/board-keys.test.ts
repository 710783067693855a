// Editing the boards with the keyboard alone, and hearing what is under the cursor.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNoBarrier } from "./support/barriers.js";
import { example } from "./support/core.js";
import { assertLive, type Board, board, documentOf, edit, tool } from "./support/hands.js";
import { stepIs, useDocument } from "./support/playground.js";

/** The example with observers who know the start: every edit is solved in no time. */
const quick = (() => {
  const { observers, ...rest } = JSON.parse(example);
  const knowing = ({ sensor }: { sensor: object }) => ({ sensor });
  return JSON.stringify({
    ...rest,
    observers: { adversarial: knowing(observers.adversarial), cooperative: knowing(observers.cooperative) },
  });
})();

const says = (page: Page, words: string) =>
  page.locator("[aria-live=polite]", { hasText: words }).waitFor({ state: "attached" });

/** Goes to a board by keyboard, so that it shows its cursor. */
async function goToBoard(page: Page, name: Board): Promise<void> {
  await page.locator("body").press("Tab");
  await board(page, name).focus();
  await page.waitForSelector(`[data-board=${name}] .cursor`);
}

async function keys(page: Page, ...names: string[]): Promise<void> {
  for (const name of names) await page.keyboard.press(name);
}

test("Tab comes by every board, and the cursor tells what is there", () =>
  edit(async (page) => {
    const met = new Set<string>();
    for (let count = 0; count < 24; count += 1) {
      await page.keyboard.press("Tab");
      met.add((await page.evaluate(() => document.activeElement?.getAttribute("data-board"))) ?? "");
    }
    for (const name of ["actor", "adversarial", "cooperative"]) assert(met.has(name), `${name} was not met`);
    await goToBoard(page, "actor");
    await says(page, "column 0, row 7: start");
    await keys(page, "ArrowUp", "ArrowUp", "ArrowUp", "ArrowUp");
    await says(page, "column 0, row 3: wall");
    await keys(page, "ArrowLeft");
    await says(page, "column 0, row 3: wall");
    await goToBoard(page, "adversarial");
    await keys(page, "ArrowRight", "ArrowUp");
    await says(page, "column 1, row 6: in the first belief");
    assert.equal(await page.locator("[data-board=actor] .cursor").count(), 0);
  }));

test("Enter picks up and puts down, Escape and leaving put back", () =>
  edit(async (page) => {
    await useDocument(page, quick);
    await documentOf(page);
    await goToBoard(page, "actor");
    await keys(page, "Enter");
    await says(page, "start picked up");
    await keys(page, "ArrowUp", "ArrowUp");
    await says(page, "start at column 0, row 5");
    await page.waitForSelector('[data-board="cooperative"] .start[cy="5.5"]');
    await keys(page, "Space");
    assert.deepEqual((await assertLive(page)).start, [0, 5]);
    // Onto a wall: it waits where it could stand last.
    await keys(page, "Enter", "ArrowRight", "ArrowRight");
    await says(page, "start can’t stand at column 2, row 5");
    await keys(page, "Enter");
    assert.deepEqual((await assertLive(page)).start, [1, 5]);
    await keys(page, "ArrowLeft", "Enter", "ArrowDown", "ArrowDown", "Escape");
    await says(page, "put back");
    assert.deepEqual((await assertLive(page)).start, [1, 5]);
    await goToBoard(page, "cooperative");
    await keys(page, "Enter", "ArrowDown", "Tab");
    assert.deepEqual((await assertLive(page)).start, [1, 5]);
    await keys(page, "Control+z", "Control+z");
    assert.deepEqual((await assertLive(page)).start, [0, 7]);
  }));

test("w, g, b, c and Delete change what is under the cursor", () =>
  edit(async (page) => {
    await goToBoard(page, "adversarial");
    await keys(page, "ArrowRight", "ArrowRight", "ArrowRight", "w");
    await says(page, "column 3, row 7: wall");
    assert((await assertLive(page)).walls?.map(String).includes("3,7"));
    await keys(page, "g");
    await says(page, "A goal can’t stand in a wall.");
    await keys(page, "Delete", "g");
    await says(page, "column 3, row 7: goal G5");
    assert.deepEqual((await assertLive(page)).goals.at(-1), { name: "G5", cell: [3, 7] });
    await keys(page, "w");
    await says(page, "that can’t be here");
    await keys(page, "Delete", "b");
    await stepIs(page, 0);
    assert.deepEqual((await assertLive(page)).observers.adversarial.initial_belief?.at(-1), [3, 7]);
    await keys(page, "b", "c");
    await says(page, "column 3, row 7: camera");
    const { observers, goals } = await assertLive(page);
    assert.deepEqual([observers.adversarial.cameras, goals.length], [[[3, 7]], 4]);
    await keys(page, "Delete");
    await says(page, "there is nothing to remove here");
    await goToBoard(page, "actor");
    await keys(page, "c");
    await says(page, "that is for the enemy’s and the friend’s board");
  }));

test("a brush paints under the cursor", () =>
  edit(async (page) => {
    await tool(page, "Walls");
    await goToBoard(page, "actor");
    await keys(page, "ArrowUp", "Enter", "ArrowUp", " ");
    const walls = (await assertLive(page)).walls?.map(String);
    assert(walls?.includes("0,6") && walls.includes("0,5"));
    await keys(page, "Enter");
    assert(!(await assertLive(page)).walls?.map(String).includes("0,5"));
  }));

test("keys with a text field in focus stay there", () =>
  edit(async (page) => {
    await goToBoard(page, "actor");
    await keys(page, "ArrowUp", "w");
    const edited = await documentOf(page);
    const field = page.getByLabel("Plan length");
    await field.fill("1");
    await field.pressSequentially("6w");
    await keys(page, "Control+z");
    assert.deepEqual((await documentOf(page)).walls, edited.walls);
  }));

test("axe finds no barrier while editing, light and dark", () =>
  edit(
    async (page) => {
      await goToBoard(page, "adversarial");
      await keys(page, "c", "Enter", "ArrowUp", "ArrowUp");
      await documentOf(page);
      await page.getByRole("tab", { name: "Edit" }).click();
      await page.getByLabel("Name of goal 1").fill("G2");
      await page.getByLabel("Name of goal 1").press("Enter");
      await page.getByText("is taken").waitFor();
      await assertNoBarrier(page, "editing", { dark: true });
    },
    { reducedMotion: "reduce" },
  ));
