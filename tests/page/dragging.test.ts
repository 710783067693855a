// Editing the boards by mouse and by finger: the best plan follows while something is dragged.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { GridworldDocument } from "../../www/src/problem/types.js";
import { example } from "./support/core.js";
import { grid } from "./support/documents.js";
import { assertLive, board, documentOf, dragMouse, dragTouch, edit, middle, tool } from "./support/hands.js";
import { attribute, press, statusIs, stepIs, useDocument } from "./support/playground.js";

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** The document is as the test says; then the page's answer is the core's. */
async function documentIs(page: Page, property: (document: GridworldDocument) => unknown, value: unknown) {
  assert.deepEqual(property(await assertLive(page)), value);
}

test("a wall, a goal and the start are dragged by mouse, and undone, redone, reset", () =>
  edit(async (page) => {
    const before = await documentOf(page);
    await dragMouse(page, "actor", [
      [2, 1],
      [2, 0],
    ]);
    await documentIs(page, ({ walls }) => walls?.some(([c, r]) => c === 2 && r === 0), true);
    await dragMouse(page, "actor", [
      [6, 7],
      [5, 4],
    ]);
    await documentIs(page, ({ goals }) => goals[1]?.cell, [5, 4]);
    await dragMouse(page, "actor", [
      [0, 7],
      [4, 7],
    ]);
    await documentIs(page, ({ start }) => start, [4, 7]);
    await page.keyboard.press("Control+z");
    await documentIs(page, ({ start }) => start, [0, 7]);
    await press(page, "Undo");
    await documentIs(page, ({ goals }) => goals[1]?.cell, [6, 7]);
    await page.keyboard.press("Control+Shift+Z");
    await documentIs(page, ({ goals }) => goals[1]?.cell, [5, 4]);
    await page.keyboard.press("Control+y");
    await documentIs(page, ({ start }) => start, [4, 7]);
    await press(page, "Reset");
    assert.deepEqual(await documentOf(page), before);
    await press(page, "Undo");
    await documentIs(page, ({ start }) => start, [4, 7]);
  }));

test("start and goals are dragged on the observers' boards, walls are not", () =>
  edit(async (page) => {
    await dragMouse(page, "adversarial", [
      [1, 0],
      [3, 0],
    ]);
    await documentIs(page, ({ goals }) => goals[2]?.cell, [3, 0]);
    await dragMouse(page, "cooperative", [
      [0, 7],
      [0, 5],
    ]);
    await documentIs(page, ({ start }) => start, [0, 5]);
    await dragMouse(page, "cooperative", [
      [3, 2],
      [3, 4],
    ]);
    await documentIs(page, ({ walls }) => walls, JSON.parse(example).walls);
  }));

test("the plan follows while the pointer is still down, and Escape takes it back", () =>
  edit(async (page) => {
    const before = await documentOf(page);
    await dragMouse(
      page,
      "actor",
      [
        [7, 0],
        [4, 0],
      ],
      async () => {
        await page.waitForSelector('[data-board="actor"] [data-goal=G1][transform="translate(4.5 0.5)"]');
        await statusIs(page, "optimal");
        await page.keyboard.press("Escape");
        await page.waitForSelector('[data-board="actor"] [data-goal=G1][transform="translate(7.5 0.5)"]');
      },
    );
    assert.deepEqual(await documentOf(page), before);
    assert.equal(await page.getByRole("button", { name: "Undo" }).getAttribute("aria-disabled"), "true");
  }));

test("what may not stand in a cell waits where it could last", () =>
  edit(async (page) => {
    // Over one free cell onto a wall.
    await dragMouse(
      page,
      "actor",
      [
        [7, 4],
        [7, 3],
        [6, 3],
      ],
      () => page.waitForSelector(".carried.refused"),
    );
    await documentIs(page, ({ goals }) => goals[3]?.cell, [7, 3]);
    // Two goals may share a cell.
    await dragMouse(page, "actor", [
      [7, 3],
      [7, 0],
    ]);
    await documentIs(page, ({ goals }) => [goals[0]?.cell, goals[3]?.cell], [
      [7, 0],
      [7, 0],
    ]);
  }));

test("a pointer that is lost takes the drag back", () =>
  edit(async (page) => {
    const before = await documentOf(page);
    await dragMouse(
      page,
      "actor",
      [
        [0, 7],
        [0, 5],
      ],
      async () => {
        await page.waitForSelector('[data-board="actor"] .start[cy="5.5"]');
        await board(page, "actor").evaluate((svg) =>
          svg.dispatchEvent(new PointerEvent("pointercancel", { pointerId: 1, bubbles: true })),
        );
        await page.waitForSelector('[data-board="actor"] .start[cy="7.5"]');
      },
    );
    assert.deepEqual(await documentOf(page), before);
  }));

test("walls are painted and taken away; the first cell decides", () =>
  edit(async (page) => {
    await tool(page, "Walls");
    const walls = (JSON.parse(example).walls as number[][]).map(String);
    await dragMouse(page, "actor", [
      [3, 6],
      [3, 7],
      [1, 7],
    ]);
    const built = await assertLive(page);
    assert.deepEqual(built.walls?.map(String).sort(), [...walls, "3,6", "3,7", "2,7", "1,7"].sort());
    // The enemy held 2,7 possible: no more.
    assert.deepEqual(built.observers.adversarial.initial_belief?.map(String), ["0,7", "1,6"]);
    // From a wall over free cells: takes away only.
    await dragMouse(page, "actor", [
      [1, 7],
      [3, 7],
      [3, 5],
    ]);
    const taken = await assertLive(page);
    assert.deepEqual(taken.walls?.map(String).sort(), walls.filter((wall) => wall !== "3,5").sort());
    // Start and goals stay free.
    await dragMouse(page, "adversarial", [
      [0, 6],
      [0, 7],
    ]);
    const kept = await assertLive(page);
    assert(!kept.walls?.map(String).includes("0,7"));
    // A quick hand that skips cells leaves no holes.
    await press(page, "Reset");
    const [from, to] = [await middle(page, "actor", [0, 4]), await middle(page, "actor", [6, 4])];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y);
    await page.mouse.up();
    const row = (await assertLive(page)).walls?.filter(([, r]) => r === 4).length;
    assert.equal(row, 7);
  }));

test("first beliefs are painted at step 0, and the start stays in", () =>
  edit(async (page) => {
    await tool(page, "First belief");
    await stepIs(page, 0);
    await dragMouse(page, "cooperative", [
      [3, 7],
      [5, 7],
    ]);
    const painted = await assertLive(page);
    assert.deepEqual(painted.observers.cooperative.initial_belief?.map(String), ["0,7", "3,7", "4,7", "5,7"]);
    await dragMouse(page, "cooperative", [
      [5, 7],
      [0, 7],
    ]);
    const cleared = await assertLive(page);
    assert.equal(cleared.observers.cooperative.initial_belief, undefined);
    assert.equal(await attribute(page, "data-step"), "0");
    // The agent's board has no belief.
    await dragMouse(page, "actor", [
      [3, 7],
      [5, 7],
    ]);
    assert.deepEqual((await assertLive(page)).observers, cleared.observers);
  }));

test("cameras are painted on an observer's board", () =>
  edit(async (page) => {
    await tool(page, "Cameras");
    await dragMouse(page, "adversarial", [
      [7, 0],
      [7, 1],
    ]);
    const watched = await assertLive(page);
    assert.deepEqual(watched.observers.adversarial.cameras, [
      [7, 0],
      [7, 1],
    ]);
    assert.notEqual(await board(page, "adversarial").locator(".camera").getAttribute("d"), "");
    await dragMouse(page, "adversarial", [
      [7, 1],
      [7, 0],
    ]);
    assert.equal((await assertLive(page)).observers.adversarial.cameras, undefined);
  }));

test("a finger drags goals and walls, and scrolls the page elsewhere", () =>
  edit(async (page) => {
    assert.equal(
      await dragTouch(page, "actor", [
        [6, 7],
        [6, 5],
      ]),
      0,
    );
    await documentIs(page, ({ goals }) => goals[1]?.cell, [6, 5]);
    assert.equal(
      await dragTouch(page, "actor", [
        [3, 5],
        [4, 6],
      ]),
      0,
    );
    await documentIs(page, ({ walls }) => walls?.map(String).includes("4,6"), true);
    await tool(page, "Walls");
    assert.equal(
      await dragTouch(page, "actor", [
        [3, 4],
        [3, 7],
      ]),
      0,
    );
    await documentIs(page, ({ walls }) => walls?.filter(([c, r]) => c === 3 && r >= 4).length, 4);
    await tool(page, "Move");
    const walls = (await documentOf(page)).walls;
    await page.evaluate(() => scrollTo(0, 0));
    assert(
      (await dragTouch(page, "actor", [
        [5, 4],
        [5, 1],
      ])) > 0,
      "an empty cell scrolls",
    );
    assert.deepEqual((await documentOf(page)).walls, walls);
  }, phone));

for (const [device, options] of [
  ["desktop", {}],
  ["phone", phone],
] as const) {
  test(`the boards stay where they are under the hand, ${device}`, () =>
    edit(async (page) => {
      const top = () => board(page, "actor").evaluate((svg) => svg.getBoundingClientRect().top + scrollY);
      const before = await top();
      await dragMouse(
        page,
        "actor",
        [
          [7, 0],
          [4, 0],
        ],
        async () => {
          await page.waitForSelector('[data-board="actor"] [data-goal=G1][transform="translate(4.5 0.5)"]');
          await documentOf(page);
          assert.equal(await top(), before);
        },
      );
      // Then the page says that the problem is edited.
      await page.getByText("An edited problem").waitFor();
    }, options));
}

test("small cells are taken hold of from nearby", () =>
  edit(async (page) => {
    await useDocument(
      page,
      grid({
        width: 32,
        height: 32,
        walls: [],
        start: [16, 16],
        goals: [
          { name: "A", cell: [28, 4] },
          { name: "B", cell: [3, 28] },
        ],
        true_goal: "A",
      }),
    );
    await page.waitForSelector("[data-goal=B]");
    await statusIs(page, "optimal", "feasible");
    const { x, y } = await middle(page, "actor", [28, 4]);
    const { x: left } = await middle(page, "actor", [24, 4]);
    const cell = (x - left) / 4;
    assert(cell < 12, "the cells are small");
    const session = await page.context().newCDPSession(page);
    const send = (type: "touchStart" | "touchMove" | "touchEnd", touchPoints: { x: number; y: number }[]) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints });
    await send("touchStart", [{ x: x + 11, y: y + 11 }]);
    for (let part = 1; part <= 4; part += 1) await send("touchMove", [{ x: x - 2 * part * cell, y }]);
    await send("touchEnd", []);
    await documentIs(page, ({ goals }) => goals[0]?.cell, [20, 4]);
  }, phone));
