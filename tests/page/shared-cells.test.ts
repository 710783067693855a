// Goals, and the start, that stand in one cell: all are seen, and each can be taken in the hand.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNoBarrier } from "./support/barriers.js";
import { assertLive, board, documentOf, dragMouse, edit } from "./support/hands.js";
import { attribute, press, stepIs } from "./support/playground.js";

/** The middles of the badges of goals on a board, in pixels, and how large the smaller side of one is. */
const badges = (page: Page, names: string[]) =>
  Promise.all(
    names.map(async (name) => {
      const box = await board(page, "actor").locator(`[data-goal="${name}"] .badge`).boundingBox();
      return box ?? assert.fail(`${name} is not drawn`);
    }),
  );

const apart = (one: { x: number; y: number }, other: { x: number; y: number }) =>
  Math.hypot(one.x - other.x, one.y - other.y);

async function dragFrom(page: Page, from: { x: number; y: number }, by: { x: number; y: number }): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + by.x, from.y + by.y, { steps: 5 });
  await page.mouse.up();
}

test("goals in one cell stand beside each other, and each can be carried away", () =>
  edit(async (page) => {
    for (const from of [
      [7, 0],
      [1, 0],
    ] as [number, number][])
      await dragMouse(page, "actor", [from, [6, 7]]);
    const document = await assertLive(page);
    assert.deepEqual(
      document.goals.slice(0, 3).map(({ cell }) => cell),
      [
        [6, 7],
        [6, 7],
        [6, 7],
      ],
    );
    const names = ["G1", "G2", "G3"];
    const boxes = await badges(page, names);
    for (const [index, one] of boxes.entries())
      for (const other of boxes.slice(index + 1))
        assert(apart(one, other) >= one.height, "two goals lie on each other");
    const star = (await board(page, "actor").locator(".star").boundingBox()) ?? assert.fail();
    const [first] = boxes;
    assert(first && star.y < first.y + first.height && star.y + star.height > first.y, "the star is at the true goal");
    await assertNoBarrier(page, "goals in one cell");
    const [, , third] = boxes;
    const cell = ((await board(page, "actor").boundingBox()) ?? assert.fail()).width / 8;
    assert(third);
    await dragFrom(
      page,
      { x: third.x + third.width / 2, y: third.y + third.height / 2 },
      { x: -2 * cell, y: -0.2 * cell },
    );
    const after = await assertLive(page);
    assert.deepEqual(
      after.goals.slice(0, 3).map(({ cell }) => cell),
      [
        [6, 7],
        [6, 7],
        [4, 7],
      ],
    );
  }));

test("a start that shares its cell with a goal is a ring around it, and can be carried by the ring", () =>
  edit(async (page) => {
    await dragMouse(page, "actor", [
      [6, 7],
      [0, 7],
    ]);
    await assertLive(page);
    const ring = (await board(page, "actor").locator(".start").boundingBox()) ?? assert.fail();
    const [badge] = await badges(page, ["G2"]);
    assert(badge && ring.width > badge.width && ring.height > badge.height);
    const cell = ring.width / 0.92;
    await dragFrom(page, { x: ring.x + ring.width / 2, y: ring.y + 1 }, { x: 2 * cell, y: 0.1 * cell });
    const { start, goals } = await assertLive(page);
    assert.deepEqual(start, [2, 7]);
    assert.deepEqual(goals[1]?.cell, [0, 7]);
  }));

test("a goal that is clicked on a board is chosen: the step that ends it is shown", () =>
  edit(async (page) => {
    const before = await documentOf(page);
    await board(page, "cooperative").locator("[data-goal=G4]").click();
    const died = /^G4: .*for the friend it is possible until step \d+; “.*” at step (\d+) ends that/;
    const sentence = (await page.locator(".story").getByText(died).textContent()) ?? "";
    await stepIs(page, Number(died.exec(sentence)?.[1]));
    assert.deepEqual(await documentOf(page), before);
  }));

test("another problem that is opened in the middle of a drag is the one on the page", () =>
  edit(async (page) => {
    const at = (await board(page, "actor").locator("[data-goal=G2] .badge").boundingBox()) ?? assert.fail();
    await page.mouse.move(at.x + 5, at.y + 5);
    await page.mouse.down();
    await page.mouse.move(at.x - 60, at.y - 30, { steps: 4 });
    const title = page.locator(".problem-bar .title");
    await page.getByRole("button", { name: "Next problem" }).press("Enter");
    await title.getByText("Head fake past a decoy").waitFor();
    const opened = await assertLive(page);
    await page.mouse.move(at.x - 120, at.y - 60, { steps: 4 });
    await page.mouse.up();
    assert.deepEqual(await assertLive(page), opened);
    assert.equal(await title.textContent(), "Head fake past a decoy");
  }));

test("what was edited lies between the same problems as before", () =>
  edit(async (page) => {
    const title = page.locator(".problem-bar .title");
    await press(page, "Next problem");
    await title.getByText("Head fake past a decoy").waitFor();
    await page.getByRole("tab", { name: "Edit" }).click();
    await page.getByLabel("Name of goal 1").fill("Elsewhere");
    await page.getByLabel("Name of goal 1").press("Enter");
    await title.getByText("An edited problem").waitFor();
    await press(page, "Problem before");
    await title.getByText("The paper’s gridworld").waitFor();
    assert.equal(await attribute(page, "data-status"), "optimal");
  }));
