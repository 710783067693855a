// As many candidate goals as there may be: the page's own thread is never held up for long, and every goal is shown.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { manyGoals } from "./support/documents.js";
import { watched } from "./support/main-thread.js";
import { attribute, openTab, statusIs } from "./support/playground.js";

/** What a person feels as a stop. */
const MOST_MS = 100;
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
    const document = JSON.stringify(manyGoals(GOALS));
    const tooLong: string[] = [];
    const tell = (what: string, { longest, total }: { longest: number; total: number }) => {
      const words = `${what}: longest task ${longest.toFixed(0)} ms, all ${total.toFixed(0)} ms`;
      console.log(words);
      if (longest >= MOST_MS) tooLong.push(words);
    };
    tell(
      "opening",
      await watched(page, async () => {
        await page.evaluate(`document.querySelector("mo-copp-playground").view.playground.edits.open(${document})`);
        await goalsShown(page, await attribute(page, "data-step"));
      }),
    );
    const last = Number(await attribute(page, "data-step"));
    assert(last > 5);
    for (let step = last - 1; step > last - 4; step -= 1) {
      tell(
        `a step back to ${step}`,
        await watched(page, async () => {
          await page.keyboard.press("ArrowLeft");
          await goalsShown(page, String(step));
          await page.waitForFunction(
            () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true)))),
          );
        }),
      );
    }
    for (const tab of ["Edit", "Steps", "Play", "Solve"]) {
      tell(
        `the tab ${tab}`,
        await watched(page, async () => {
          await openTab(page, tab);
          await page.waitForTimeout(500);
        }),
      );
    }
    const step = await attribute(page, "data-step");
    const more = page.locator(".below .more button");
    assert.equal(await more.innerText(), "Show all 1,024 goals");
    await more.click();
    await goalsShown(page, step, GOALS);
    assert.equal(await more.innerText(), "Show 100 goals");
    await more.click();
    await goalsShown(page, step);
    assert.deepEqual(tooLong, []);
  }));
