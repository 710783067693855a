// Memory stays where it is, however long somebody edits.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { CDPSession, Page } from "playwright-core";
import init, { Problem } from "../../www/pkg/mo_copp.js";
import { example } from "./support/core.js";
import { dragMouse, edit } from "./support/hands.js";
import { statusIs } from "./support/playground.js";

const EDITS = 200;

/** Each is another problem than the one before: a wall that comes and goes, a goal that is dragged to and fro. */
async function editOften(page: Page): Promise<void> {
  for (let count = 0; count < EDITS; count += 1) {
    if (count % 20 === 0) {
      const way: [number, number][] = [
        [6, 7],
        [4, 7],
      ];
      await dragMouse(page, "actor", count % 40 === 0 ? way : way.reverse());
      // The cursor waits where the mouse was; the cell beside it is free.
      await page.keyboard.press("ArrowLeft");
    } else {
      const before = await page.evaluate("lastDocument");
      await page.keyboard.press("w");
      await page.waitForFunction(
        (document) => (window as unknown as { lastDocument: string }).lastDocument !== document,
        before,
      );
    }
    await statusIs(page, "optimal");
  }
}

async function used(session: CDPSession): Promise<{ heap: number; nodes: number; listeners: number }> {
  await session.send("HeapProfiler.collectGarbage");
  const { metrics } = await session.send("Performance.getMetrics");
  const value = (name: string) => metrics.find((metric) => metric.name === name)?.value ?? assert.fail(name);
  return { heap: value("JSHeapUsedSize"), nodes: value("Nodes"), listeners: value("JSEventListeners") };
}

test("two hundred edits leave no more in memory than two hundred before them", () =>
  edit(async (page) => {
    const session = await page.context().newCDPSession(page);
    await session.send("HeapProfiler.enable");
    await session.send("Performance.enable");
    // The first fill what is kept to undo them.
    await editOften(page);
    const before = await used(session);
    await editOften(page);
    const after = await used(session);
    assert(after.heap < before.heap * 1.1 + 300_000, `${before.heap} bytes became ${after.heap}`);
    assert(after.nodes < before.nodes + 500, `${before.nodes} nodes became ${after.nodes}`);
    assert(after.listeners < before.listeners + 50, `${before.listeners} listeners became ${after.listeners}`);
  }));

test("the core gives back what a problem took", async () => {
  const { memory } = await init();
  const solve = (count: number) => {
    const document = JSON.parse(example);
    document.walls.push([count % 2 === 0 ? 4 : 5, 0]);
    const problem = new Problem(JSON.stringify(document));
    const run = problem.solve({ solver: "exact" });
    while (!run.advance(10_000));
    problem.trace(run.outcome().plan ?? []);
    run.free();
    problem.free();
  };
  for (let count = 0; count < EDITS; count += 1) solve(count);
  const before = memory.buffer.byteLength;
  for (let count = 0; count < EDITS; count += 1) solve(count);
  assert.equal(memory.buffer.byteLength, before);
});
