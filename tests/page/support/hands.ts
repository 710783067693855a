// Working the boards as a person does: with a mouse, a finger or the keyboard.
import assert from "node:assert/strict";
import type { Page } from "playwright-core";
import type { GridworldDocument } from "../../../www/src/problem/types.js";
import { type Options, visit } from "./browser.js";
import { solve } from "./core.js";
import { assertDrawn, attribute, drawn, statusIs } from "./playground.js";

export type Board = "actor" | "adversarial" | "cooperative";
type Cell = readonly [column: number, row: number];

export const board = (page: Page, name: Board) => page.locator(`svg[data-board="${name}"]`);

/** The middle of a cell on the screen. */
export async function middle(page: Page, name: Board, [column, row]: Cell): Promise<{ x: number; y: number }> {
  // The whole board, so that every cell stays where it is found.
  await board(page, name).scrollIntoViewIfNeeded();
  const cell = board(page, name).locator(`[data-cell="${column},${row}"]`);
  const box = (await cell.boundingBox()) ?? assert.fail("the cell is not drawn");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Presses in one cell, goes through others, and lets go in the last; `last` runs before that. */
export async function dragMouse(page: Page, name: Board, cells: Cell[], last?: () => Promise<unknown>): Promise<void> {
  const points = await all(page, name, cells);
  for (const [index, { x, y }] of points.entries()) {
    await page.mouse.move(x, y, { steps: index === 0 ? 1 : 4 });
    if (index === 0) await page.mouse.down();
  }
  await last?.();
  await page.mouse.up();
}

/** The same with a finger; resolves to how far the page was scrolled by it. */
export async function dragTouch(
  page: Page,
  name: Board,
  cells: Cell[],
  last?: () => Promise<unknown>,
): Promise<number> {
  const points = await all(page, name, cells);
  const session = await page.context().newCDPSession(page);
  const send = (type: "touchStart" | "touchMove" | "touchEnd", touchPoints: { x: number; y: number }[]) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints });
  const before = await page.evaluate(() => scrollY);
  let from = points[0] ?? assert.fail("no cell to touch");
  await send("touchStart", [from]);
  for (const to of points.slice(1)) {
    // A browser makes up its mind about scrolling from the first few moves.
    for (let part = 1; part <= 6; part += 1) {
      await send("touchMove", [{ x: from.x + ((to.x - from.x) * part) / 6, y: from.y + ((to.y - from.y) * part) / 6 }]);
    }
    from = to;
  }
  await last?.();
  await send("touchEnd", []);
  await session.detach();
  return (await page.evaluate(() => scrollY)) - before;
}

async function all(page: Page, name: Board, cells: Cell[]): Promise<{ x: number; y: number }[]> {
  const points = [];
  for (const cell of cells) points.push(await middle(page, name, cell));
  return points;
}

/** Opens the page with its documents in reach. */
export const edit = (use: (page: Page) => Promise<void>, options: Options = {}): Promise<void> =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await use(page);
    },
    { ...options, before: (page) => page.addInitScript(rememberDocuments) },
  );

/** The last document that went to a worker is the one whose plan is shown next. */
const rememberDocuments = `
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message) {
    if (message.kind === "solve") window.lastDocument = message.document;
    post.call(this, message);
  };
`;

/** The document whose plan is shown, once the solver has answered; the page's first answer is drawn before a worker has the document. */
export async function documentOf<T = GridworldDocument>(page: Page): Promise<T> {
  await page.waitForSelector('mo-copp-playground:not([data-status="solving"])');
  await page.waitForFunction("window.lastDocument !== undefined");
  return JSON.parse(await page.evaluate<string>("lastDocument")) as T;
}

/** Checks that the plan shown is what the core in Node says of the document, at the step shown. */
export async function assertLive(page: Page): Promise<GridworldDocument> {
  const document = await documentOf(page);
  const { outcome, trace } = solve(JSON.stringify(document), { solver: "exact" });
  assert.equal(await attribute(page, "data-status"), outcome.status);
  const difference = outcome.goal_difference;
  assert.equal(await attribute(page, "data-gd"), difference === null ? null : String(difference));
  const step = Number(await attribute(page, "data-step"));
  assertDrawn(await drawn(page), trace.steps[step] ?? assert.fail(`no step ${step}`), document.true_goal);
  return document;
}

export const tool = (page: Page, name: string) =>
  page.getByRole("group", { name: "Tools" }).getByRole("button", { name, exact: true }).click();
