// The help, the glossary, and the keys that work anywhere.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { openTab, press, slider, statusIs, stepIs } from "./support/playground.js";

const help = (page: Page) => page.getByRole("dialog", { name: "Help" });

const focusIsOn = (page: Page, selector: string) =>
  page.waitForFunction((wanted) => document.activeElement?.matches(wanted) === true, selector);

test("? opens the help, Escape closes it, and the focus comes back", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.getByRole("button", { name: "Play", exact: true }).focus();
    await page.keyboard.press("?");
    await help(page).waitFor();
    for (const key of ["Home", "Space", "Delete", "Ctrl+Z", "Escape", "?"]) {
      await help(page).locator("kbd", { hasText: key }).first().waitFor();
    }
    await page.keyboard.press("Escape");
    await help(page).waitFor({ state: "hidden" });
    await focusIsOn(page, '[aria-label="Play"]');
    // In a text field it is a letter.
    await openTab(page, "Document");
    await page.getByLabel("Problem document (JSON)").press("?");
    assert.equal(await help(page).isVisible(), false);
    // And there is a button for those without a keyboard.
    await press(page, "Help");
    await help(page).waitFor();
    await help(page).getByRole("button", { name: "Close" }).click();
    await help(page).waitFor({ state: "hidden" });
    await focusIsOn(page, '[aria-label="Help"]');
  }));

test("a click beside the help closes it, one in it does not", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await press(page, "Help");
    await help(page).waitFor();
    const box = (await help(page).boundingBox()) ?? assert.fail();
    await page.mouse.click(box.x + box.width / 2, box.y + 150);
    assert.equal(await help(page).isVisible(), true);
    await page.mouse.click(box.x - 30, box.y + 150);
    await help(page).waitFor({ state: "hidden" });
  }));

test("words of the page lead to what they mean", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    let found = 0;
    for (const tab of ["Solve", "Steps", "Compare", "Trade-off"]) {
      await openTab(page, tab);
      const words = page.locator("mo-copp-playground button.term");
      for (let index = 0; index < (await words.count()); index += 1) {
        const word = words.nth(index);
        const term = await word.getAttribute("data-term");
        await word.click();
        await focusIsOn(page, `[data-entry="${term}"]`);
        const entry = help(page).locator(`[data-entry="${term}"]`);
        const box = (await entry.boundingBox()) ?? assert.fail();
        const frame = (await help(page).boundingBox()) ?? assert.fail();
        assert(box.y >= frame.y && box.y < frame.y + frame.height, `${term} is in sight`);
        await page.keyboard.press("Escape");
        await help(page).waitFor({ state: "hidden" });
        found += 1;
      }
    }
    assert(found > 15, `${found} words`);
  }));

test("the glossary has the words of the paper, with its formula", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await press(page, "Help");
    await help(page).waitFor();
    const names = await help(page).locator("dt").allTextContents();
    const words = ["Enemy", "Friend", "Sensor", "Symbol", "Belief", "Candidate goal", "True goal", "Possible", "Plan"];
    for (const word of [
      ...words,
      "Goal difference",
      "k",
      "j",
      "Obfuscation",
      "Legibility",
      "Head fake",
      "Proved",
      "Best found",
    ]) {
      assert(
        names.some((name) => name.startsWith(word)),
        `no ${word}`,
      );
    }
    assert.equal(new Set(names).size, names.length);
    // Real MathML, not unknown elements of HTML.
    const formula = help(page).locator("math[display=block] mfrac");
    assert.equal(await formula.evaluate((element) => element.namespaceURI), "http://www.w3.org/1998/Math/MathML");
    const all = await help(page)
      .locator("dt math *")
      .evaluateAll((parts) => parts.map((part) => part.namespaceURI));
    assert(all.length > 10 && all.every((space) => space === "http://www.w3.org/1998/Math/MathML"));
    // From one definition to another.
    await help(page).locator('[data-entry="head-fake"]').getByRole("button", { name: "decoy" }).click();
    await focusIsOn(page, '[data-entry="decoy"]');
  }));

test("arrows, Home, End and Space work from anywhere but where they mean something else", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.locator("h1").click();
    await page.keyboard.press("Home");
    await stepIs(page, 0);
    await page.keyboard.press("ArrowRight");
    await stepIs(page, 1);
    await page.keyboard.press("ArrowRight");
    await stepIs(page, 2);
    await page.keyboard.press("ArrowLeft");
    await stepIs(page, 1);
    await page.keyboard.press("End");
    await stepIs(page, 16);
    await page.keyboard.press("Home");
    await page.keyboard.press(" ");
    await page.getByRole("button", { name: "Pause", exact: true }).waitFor();
    await page.keyboard.press(" ");
    await page.getByRole("button", { name: "Play", exact: true }).waitFor();
    await page.keyboard.press("Home");
    await stepIs(page, 0);
    // On a button arrows step, and Space presses it.
    await page.getByRole("button", { name: "Copy link" }).focus();
    await page.keyboard.press("ArrowRight");
    await stepIs(page, 1);
    // On a tab, in a list, in a field, on a board and in a dialog they are not the steps'.
    await page.getByRole("tab", { name: "Solve" }).focus();
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.getByRole("tab", { name: "Edit" }).getAttribute("aria-selected"), "true");
    await openTab(page, "Solve");
    await page.getByLabel("Solver").press("End");
    await page.getByLabel("Plan length").press("Home");
    await page.getByLabel("Plan length").press("ArrowLeft");
    await page.locator('[data-board="actor"]').first().focus();
    await page.keyboard.press("ArrowRight");
    await press(page, "Help");
    await help(page).waitFor();
    await page.keyboard.press("End");
    await page.keyboard.press("Escape");
    await stepIs(page, 1);
    // With a modifier they are the browser's.
    await page.locator("h1").click();
    await page.keyboard.press("Shift+End");
    await stepIs(page, 1);
    // The slider moves by one with its own keys, not by two.
    await slider(page).press("ArrowRight");
    await stepIs(page, 2);
  }));

test("the keyboard alone opens the help, reads a word and goes on", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await page.keyboard.press("?");
      await help(page).waitFor();
      await page.keyboard.press("Tab");
      await page.keyboard.press("Tab");
      await page.keyboard.press("Enter");
      await focusIsOn(page, '[data-part="words"]');
      const box = (await help(page).boundingBox()) ?? assert.fail();
      assert(box.x >= 0 && box.x + box.width <= 390);
      const overflow = await help(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth);
      assert(overflow <= 0, `${overflow} pixels too wide`);
      await page.keyboard.press("Escape");
      await help(page).waitFor({ state: "hidden" });
      await page.keyboard.press("Home");
      await stepIs(page, 0);
    },
    { viewport: { width: 390, height: 844 } },
  ));

test("axe finds no barrier in the help, light and dark", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await press(page, "Help");
    await help(page).waitFor();
    await assertNoBarrier(page, "the help", { dark: true });
  }));
