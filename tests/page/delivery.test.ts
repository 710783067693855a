// The delivery, drawn as in Figure 1 of the paper.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { replay } from "./support/core.js";
import { delivery, figure1 } from "./support/documents.js";
import { assertDrawn, attribute, drawn, slider, statusIs, stepIs, useDocument } from "./support/playground.js";

const open = async (page: Page, document: string) => {
  await statusIs(page, "optimal");
  await useDocument(page, document);
  await page.locator('svg.delivery[data-board="actor"]').waitFor();
  await statusIs(page, "optimal");
};

const titles = (page: Page, board: string) =>
  page.locator(`[data-board="${board}"] .factory .package title`).allTextContents();

test("what is loaded, what each observer saw and what it believes", () =>
  visit(async ({ page }) => {
    await open(page, figure1);
    assert.equal(await attribute(page, "data-gd"), "1");
    const plan = ["load a1", "load a2", "deliver"];
    const { steps } = replay(figure1, plan);
    for (const [index, step] of steps.entries()) {
      await slider(page).fill(String(index));
      await stepIs(page, index);
      const { goals } = await drawn(page);
      assertDrawn(
        {
          believed: {
            adversarial: step.beliefs.adversarial.map(String),
            cooperative: step.beliefs.cooperative.map(String),
          },
          goals,
        },
        step,
        "a1+a2",
      );
    }
    await slider(page).fill("1");
    assert.deepEqual(await titles(page, "actor"), [
      "a1: in the truck",
      "a2: at the factory",
      "b1: at the factory",
      "b2: at the factory",
    ]);
    const perhaps = (name: string, share: number) =>
      `${name}: perhaps in the truck (in ${share} % of the believed states)`;
    assert.deepEqual(
      await titles(page, "adversarial"),
      ["a1", "a2", "b1", "b2"].map((name) => perhaps(name, 25)),
    );
    assert.deepEqual(await titles(page, "cooperative"), [
      perhaps("a1", 50),
      perhaps("a2", 50),
      "b1: surely still here",
      "b2: surely still here",
    ]);
    const seen = (board: string) => page.locator(`[data-board="${board}"] .truck .package title`).allTextContents();
    assert.deepEqual(await seen("adversarial"), ["Told: package"]);
    assert.deepEqual(await seen("cooperative"), ["Told: barcode A"]);
    assert.deepEqual(await seen("actor"), ["a1"]);
  }));

test("the six goals are pairs of packages, with who thinks them possible", () =>
  visit(async ({ page }) => {
    await open(page, figure1);
    const goals = page.locator('[data-board="actor"] [data-goal]');
    assert.equal(await goals.count(), 6);
    assert.deepEqual(await goals.first().locator("text").allTextContents(), ["a1", "a2"]);
    assert.equal(await page.locator('[data-board="actor"] [data-adversarial="alive"]').count(), 6);
    assert.equal(await page.locator('[data-board="actor"] [data-cooperative="alive"]').count(), 1);
  }));

for (const [title, document] of [
  ["one factory of many packages", delivery([12], 1)],
  ["many factories", delivery([3, 1, 2, 4, 1, 1, 2, 1, 3, 1], 2)],
  ["many goals", delivery([6, 6], 3)],
] as const) {
  test(`${title}: nothing runs off a phone's screen, and the goals are all there`, () =>
    visit(
      async ({ page }) => {
        await open(page, document);
        const overflow = await page.evaluate(() => window.document.documentElement.scrollWidth - innerWidth);
        assert(overflow <= 0, `${overflow} pixels too wide`);
        const count = replay(document, []).steps.length;
        assert.equal(count, 1);
        assert((await page.locator("tr[data-goal]").count()) >= 2);
      },
      { viewport: { width: 320, height: 740 } },
    ));
}
