// A question on paper: all that it tells, room for the answer, and nothing that only a screen can do.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { exerciseText, give, openExercise } from "./support/exercises.js";
import { press } from "./support/playground.js";
import { address } from "./support/site.js";

const example = (name: string) =>
  JSON.parse(readFileSync(new URL(`../../examples/${name}.json`, import.meta.url), "utf8"));

/** What A4 leaves between margins of 12 mm, in pixels. */
const viewport = { width: 702, height: 1032 };

/** The styles for paper are there: those of the stand-alone page come in the first pause. */
const styled = (page: Page) =>
  page.waitForFunction(() => [...document.styleSheets].some(({ href }) => /\/print-[^/]*\.css$/.test(href ?? "")));

const paper = (page: Page) => page.getByRole("region", { name: "The problem in words" });

async function onPaper(page: Page): Promise<void> {
  await styled(page);
  await page.emulateMedia({ media: "print" });
  await paper(page).waitFor();
}

async function assertForPaper(page: Page, name: string): Promise<void> {
  const left = await page.locator(".exercise :is(button, input, summary, select, textarea)").evaluateAll((all) =>
    all
      // What is ticked is the answer, and so is its code.
      .filter((one) => one.checkVisibility() && !one.matches(".cell, [type=checkbox], [type=radio], .code input"))
      .map((one) => one.outerHTML),
  );
  assert.deepEqual(left, [], name);
  assert.equal(await page.locator("#exercise-question").isVisible(), true, `${name}: the question`);
  assert.equal(await page.locator(".exercise figure img").first().isVisible(), true, `${name}: the picture`);
  const wide = await page.evaluate("document.documentElement.scrollWidth - innerWidth");
  assert(Number(wide) <= 0, `${name}: ${wide} pixels too wide`);
}

test("a question is printed with its problem in words, opened or not, and what can be ticked", () =>
  visit(
    async ({ page }) => {
      for (const opened of [false, true]) {
        await page.emulateMedia({ media: "screen" });
        await openExercise(page, "01-possible-goals");
        await press(page, "Show a hint (2 left)");
        await page.getByLabel("G1", { exact: true }).check();
        await press(page, "Check the answer");
        await page.getByText("Not right.").waitFor();
        const words = page.locator(".exercise details", { hasText: "The problem in words" });
        if (opened) await words.locator("summary").click();
        await page.getByLabel("G1", { exact: true }).focus();
        await onPaper(page);
        await assertForPaper(page, "01-possible-goals");
        for (const said of [
          "The enemy is told “vertical” for north and south",
          "Goals, each a cell for the agent: G1 at",
        ])
          assert.equal(await page.getByText(said).locator("visible=true").count(), 1, said);
        assert.equal(await page.locator(".hints li").isVisible(), true, "the hint that was shown");
        assert.equal(await page.getByText("Not right.").isVisible(), true, "what was said of the answer");
        assert.equal(await page.getByRole("checkbox").count(), 4);
        assert.equal(await page.getByLabel("Answer code").isVisible(), true, "the code");
        // On the screen all is as it was.
        await page.emulateMedia({ media: "screen" });
        await paper(page).waitFor({ state: "detached" });
        assert.equal(await words.evaluate((details) => (details as HTMLDetailsElement).open), opened);
        assert.equal(await page.evaluate("document.activeElement?.type"), "checkbox", "the focus stays");
      }
    },
    { viewport },
  ));

test("cells are ticked on paper, walks and long lists of states are written", () =>
  visit(
    async ({ page }) => {
      await openExercise(page, "06-camera");
      await onPaper(page);
      await assertForPaper(page, "06-camera");
      assert.equal(await page.locator(".cells .cell").first().isVisible(), true, "cells");
      await page.emulateMedia({ media: "screen" });
      await openExercise(page, "04-walk-length");
      await onPaper(page);
      await assertForPaper(page, "04-walk-length");
      await page.getByText("Actions: north, south, east, west.").waitFor();
      assert.equal(await page.locator(".lines").isVisible(), true, "room for a walk");
      await page.emulateMedia({ media: "screen" });
      await page.locator("[data-action=east]").click();
      await page.emulateMedia({ media: "print" });
      await page.locator(".on-paper .walk", { hasText: "east" }).waitFor();
      assert.equal(await page.locator(".lines").count(), 0, "a walk that is there already");
      await page.emulateMedia({ media: "screen" });
      const plan = ["move-forward", "move-forward", "turn-left"];
      const exercise = { kind: "belief", observer: "cooperative", plan };
      await give(page, JSON.stringify({ ...example("box-pushing"), exercise }));
      await page.getByRole("searchbox", { name: "Search" }).waitFor();
      await onPaper(page);
      await assertForPaper(page, "box-pushing");
      assert.equal(await page.locator(".lines").isVisible(), true, "room for states");
    },
    { viewport },
  ));

test("of PDDL the texts are printed whole, and a script that prints has them at once", () =>
  visit(
    async ({ page }) => {
      await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
      await give(page, JSON.stringify({ ...example("blocksworld"), exercise: { kind: "best" } }));
      await page.locator("#exercise-question").waitFor();
      await onPaper(page);
      await assertForPaper(page, "blocksworld");
      const cut = await page
        .locator(".on-paper pre")
        .evaluateAll((all) => all.map(({ scrollHeight, clientHeight }) => scrollHeight - clientHeight));
      assert.equal(cut.length, 2);
      assert(
        cut.every((hidden) => hidden <= 1),
        String(cut),
      );
      await page.emulateMedia({ media: "screen" });
      await paper(page).waitFor({ state: "detached" });
      const printed = await page.evaluate(`(() => {
        const counted = () => document.querySelectorAll(".on-paper.words").length;
        dispatchEvent(new Event("beforeprint"));
        const printed = counted();
        dispatchEvent(new Event("afterprint"));
        return [printed, counted()];
      })()`);
      assert.deepEqual(printed, [1, 0]);
    },
    { viewport },
  ));

test("in another page a question is printed the same way", () =>
  visit(
    async ({ page }) => {
      await page.route(`${address}lesson/print.html`, (route) =>
        route.fulfill({
          contentType: "text/html",
          body: `<!doctype html><html lang="en"><head><title>Lesson</title>
            <script type="module" src="../mo-copp-playground.js"></script></head><body>
            <mo-copp-playground link="off"><script type="application/json">${exerciseText("06-camera")}</script>
            </mo-copp-playground></body></html>`,
        }),
      );
      await page.goto(`${address}lesson/print.html`);
      await page.locator("#exercise-question").waitFor();
      await page.emulateMedia({ media: "print" });
      await paper(page).waitFor();
      await assertForPaper(page, "an element");
    },
    { viewport },
  ));

test("where a name decides on the question, paper without one says so", () =>
  visit(
    async ({ page }) => {
      await page.goto(`${address}?src=exercises/10-walk-both.json`);
      await page.getByLabel("Your name or number").waitFor();
      await styled(page);
      await page.emulateMedia({ media: "print" });
      const said = page.getByText("Each student has another question: give a name on the page, then print it.");
      await said.waitFor();
      await page.emulateMedia({ media: "screen" });
      await said.waitFor({ state: "detached" });
    },
    { viewport },
  ));
