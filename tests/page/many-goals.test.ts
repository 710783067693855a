// As many candidate goals as there may be: the page's own thread is never held up for long, and every goal is shown.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { grid, manyGoals } from "./support/documents.js";
import { watched } from "./support/main-thread.js";
import { attribute, openTab, statusIs } from "./support/playground.js";

/** What a person feels as a stop. */
const MOST_MS = 100;
/** Other programs slow a thread down even where their own time is left out: the best round counts. */
const ROUNDS = 10;
const GOALS = 1024;

/** In the lists the first hundred, until more are asked for. */
const LISTED = 100;

const goalsShown = (page: Page, step: string | null, listed = LISTED) =>
  page.waitForFunction(
    ([count, wanted, rowsWanted]) => {
      const element = document.querySelector<HTMLElement>("mo-copp-playground");
      const root = element?.shadowRoot ?? element;
      const rows = root?.querySelectorAll(".goals [data-goal]").length;
      const badges = root?.querySelectorAll("[data-board] [data-goal]").length;
      return element?.dataset.step === wanted && rows === rowsWanted && badges === 3 * Number(count);
    },
    [GOALS, step, listed] as const,
  );

test("a thousand goals hold the page up nowhere", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const open = (document: string) =>
      page.evaluate(
        `document.querySelector("mo-copp-playground")[Symbol.for("mo-copp view")].playground.edits.open(${JSON.stringify(document)})`,
      );
    const tooLong: string[] = [];
    /** What other programs do to the processor's caches only adds to a time: the best of three is the page's own. */
    const least = async (what: string, work: () => Promise<void>, before = async (): Promise<unknown> => undefined) => {
      let best = Number.POSITIVE_INFINITY;
      for (let round = 0; round < ROUNDS && best >= MOST_MS; round += 1) {
        await before();
        best = Math.min(best, (await watched(page, work)).longest);
      }
      console.log(`${what}: longest task ${best.toFixed(0)} ms`);
      if (best >= MOST_MS) tooLong.push(`${what}: ${best.toFixed(0)} ms`);
    };
    await least(
      "opening",
      async () => {
        await open(manyGoals(GOALS));
        await goalsShown(page, await attribute(page, "data-step"));
      },
      () => open(grid()),
    );
    const last = Number(await attribute(page, "data-step"));
    assert(last > 5);
    let step = last;
    await least("a step back", async () => {
      step -= 1;
      await page.keyboard.press("ArrowLeft");
      await goalsShown(page, String(step));
      await page.waitForFunction(
        () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true)))),
      );
    });
    for (const tab of ["Edit", "Steps", "Play", "Solve"]) {
      await least(
        `the tab ${tab}`,
        async () => {
          await openTab(page, tab);
          await page.waitForTimeout(500);
        },
        () => openTab(page, "Solve"),
      );
    }
    const more = page.locator(".below .more button");
    assert.equal(await more.innerText(), "Show all 1,024 goals");
    await more.click();
    await goalsShown(page, String(step), GOALS);
    assert.equal(await more.innerText(), "Show 100 goals");
    await more.click();
    await goalsShown(page, String(step));
    assert.deepEqual(tooLong, []);
  }));
