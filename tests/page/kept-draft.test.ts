// A text that was begun in the tab "Document", and the form in the tab "Exercise", outlive a reload, or are not left without a question.
import assert from "node:assert/strict";
import { test } from "node:test";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { addressHolds } from "./support/links.js";
import { openTab, press, statusIs, useDocument } from "./support/playground.js";
import { address } from "./support/site.js";
import { put, textIs } from "./support/text.js";

const begun = '{"format": "gridworld",\n "width": 4';

test("a text that was begun is there after a reload, until it is used or given up", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, grid());
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 12);
    // What a reload opens is what the address holds, which is written a moment later.
    await addressHolds(page, ({ document }) => document === grid());
    await put(page, begun);
    await page.reload();
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    await textIs(page, begun);
    await press(page, "Undo typing");
    await page.reload();
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    await textIs(page, grid());
    // One that was used is the page's.
    const other = grid({ width: 5 });
    await put(page, other);
    await press(page, "Use this problem");
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 15);
    await page.waitForFunction(() => sessionStorage.length === 0);
  }));

test("the form of an exercise is as it was after a reload, and untouched with another page's problem", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Exercise");
    await page.getByLabel("Kind of question").selectOption("walk");
    await page.getByLabel("Title").fill("Mine");
    await page.getByLabel("Hints, one a line").fill("One\nTwo");
    await page.getByLabel("Hide what the observers believe").check();
    await page.getByLabel("the walls").check();
    const read = async () => [
      await page.getByLabel("Kind of question").inputValue(),
      await page.getByLabel("Title").inputValue(),
      await page.getByLabel("Hints, one a line").inputValue(),
      await page.getByLabel("Hide what the observers believe").isChecked(),
      await page.getByLabel("the walls").isChecked(),
    ];
    const typed = ["walk", "Mine", "One\nTwo", true, true];
    assert.deepEqual(await read(), typed);
    await page.reload();
    await statusIs(page, "optimal");
    await openTab(page, "Exercise");
    assert.deepEqual(await read(), typed);
    await page.goto(`${address}?problem=corridor`);
    await statusIs(page, "optimal");
    await openTab(page, "Exercise");
    assert.equal(await page.getByLabel("Title").inputValue(), "");
    // Back at the problem it is there again.
    await page.goto(address);
    await statusIs(page, "optimal");
    await openTab(page, "Exercise");
    assert.deepEqual(await read(), typed);
    // What is no form is none.
    await page.evaluate(() => {
      for (const key of Object.keys(sessionStorage))
        sessionStorage.setItem(key, JSON.stringify({ text: '{"title": 5, "vary": "x"}', from: "" }));
    });
    await page.reload();
    await statusIs(page, "optimal");
    await openTab(page, "Exercise");
    assert.equal(await page.getByLabel("Title").inputValue(), "");
  }));

test("another page's problem is not taken for the one that the text was begun from", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    await put(page, begun);
    await page.goto(`${address}?problem=delivery`);
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    await page.locator(".text-field").first().waitFor();
    assert.equal(await page.getByText("The text follows the page.").count(), 1);
    // Back at the problem it is there again.
    await page.goto(address);
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    await textIs(page, begun);
  }));

test("where nothing may be kept, leaving asks first", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await openTab(page, "Document");
      await put(page, begun);
      const [dialog] = await Promise.all([
        page.waitForEvent("dialog"),
        page.evaluate("setTimeout(() => location.reload())"),
      ]);
      assert.equal(dialog.type(), "beforeunload");
      await dialog.dismiss();
      await textIs(page, begun);
      await press(page, "Undo typing");
      await page.reload();
      await statusIs(page, "optimal");
    },
    {
      before: (page) =>
        page.addInitScript(() =>
          Object.defineProperty(window, "sessionStorage", {
            get() {
              throw new DOMException("forbidden", "SecurityError");
            },
          }),
        ),
    },
  ));
