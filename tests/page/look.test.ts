// How the page looks and answers: narrow screens, both colour schemes, keyboard, and the usual barriers.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { openTab, press, statusIs, stepIs, useDocument } from "./support/playground.js";

for (const width of [320, 360, 768]) {
  test(`nothing runs off a screen ${width} pixels wide`, () =>
    visit(
      async ({ page }) => {
        await statusIs(page, "optimal");
        const long = "a-name-that-goes-on-and-on-".repeat(12);
        for (const problem of [
          null,
          grid({
            goals: [
              { name: long, cell: [3, 0] },
              { name: "G2", cell: [0, 0] },
            ],
            true_goal: long,
          }),
        ]) {
          if (problem !== null) {
            await useDocument(page, problem);
            await page.locator("tr", { hasText: long }).waitFor();
            await statusIs(page, "optimal");
          }
          const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
          assert(overflow <= 0, `${overflow} pixels too wide`);
        }
      },
      { viewport: { width, height: 740 } },
    ));
}

test("axe finds no barrier, light and dark", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await openTab(page, "Document");
      await press(page, "Forward one step");
      await assertNoBarrier(page, "a document", { dark: true });
    },
    { reducedMotion: "reduce" },
  ));

test("the keyboard alone steps and solves, and shows where it is", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    // The tools and the boards come before the steps.
    const label = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label"));
    for (let count = 0; count < 30 && (await label()) !== "First step"; count += 1) await page.keyboard.press("Tab");
    const focus = await page.evaluate(() => {
      const style = getComputedStyle(document.activeElement ?? document.body);
      return {
        label: document.activeElement?.getAttribute("aria-label"),
        outline: Number.parseFloat(style.outlineWidth),
      };
    });
    assert.equal(focus.label, "First step");
    assert(focus.outline >= 2);
    await page.keyboard.press("Enter");
    await stepIs(page, 0);
    await page.getByLabel("Plan length").focus();
    await page.keyboard.type("3");
    await page.keyboard.press("Enter");
    await statusIs(page, "infeasible");
  }));

for (const height of [568, 640, 720])
  test(`what the keyboard comes to is not behind the bar of the steps, ${height} pixels high`, () =>
    visit(
      async ({ page }) => {
        await statusIs(page, "optimal");
        await page.keyboard.press("End");
        await page.locator(".difference .value", { hasText: "Goal difference" }).waitFor();
        const seen = new Set<string>();
        for (let count = 0; count < 60; count += 1) {
          await page.keyboard.press("Tab");
          const [name, hidden] = await page.evaluate(() => {
            const { activeElement } = document;
            const bar = document.querySelector(".stepper");
            if (activeElement === null || bar === null || bar.contains(activeElement))
              return ["the bar", false] as const;
            const at = activeElement.getBoundingClientRect();
            const above = document.elementFromPoint(
              at.x + at.width / 2,
              Math.min(at.y + at.height / 2, innerHeight - 1),
            );
            const covered = bar.contains(above);
            return [
              `${activeElement.textContent?.trim() || activeElement.getAttribute("aria-label")}`,
              covered,
            ] as const;
          });
          assert.equal(hidden, false, name);
          seen.add(name);
        }
        assert(seen.has("Goal difference"), "the boards were come by");
      },
      { viewport: { width: 320, height } },
    ));

test("nothing moves by itself for those who asked for less motion", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      const moving = await page.evaluate(
        () =>
          [...document.querySelectorAll("*")].filter((part) => getComputedStyle(part).transitionDuration !== "0s")
            .length,
      );
      assert.equal(moving, 0);
    },
    { reducedMotion: "reduce" },
  ));
