// The document as text: errors at their place, nothing typed is lost, and the keyboard is enough.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { written } from "../../www/src/problem/text.js";
import { templates } from "../../www/src/text/templates.js";
import { assertNoBarrier } from "./support/barriers.js";
import { type Options, visit } from "./support/browser.js";
import { taken } from "./support/core.js";
import { endless, grid } from "./support/documents.js";
import { dragMouse } from "./support/hands.js";
import { drawn, openTab, press, statusIs, useDocument } from "./support/playground.js";
import { field, linesOf, paste, put, retype, said, textIs } from "./support/text.js";

/** Opens the tab on a small problem, in several lines. */
const small = written(JSON.parse(grid()));

const onText = (use: (page: Page) => Promise<void>, options: Options = {}) =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, small);
    await textIs(page, small);
    await statusIs(page, "optimal");
    await use(page);
  }, options);

test("what is wrong is said under the line while one types, and the problem on the page stays", () =>
  onText(async (page) => {
    const before = await drawn(page);
    await retype(page, "4", "0");
    await said(page, "width: found 0").waitFor();
    const lines = await linesOf(page);
    const at = lines.findIndex((line) => line.startsWith("["));
    assert.match(lines[at - 1] ?? "", /"width": 0/);
    assert.match(lines[at] ?? "", /found 0, expected a whole number from 1 to 256/);
    // A sign and an underline mark it as well, and the field says that something is wrong and what.
    assert.equal(await page.locator(".cm-fault").textContent(), "0");
    assert.match(await page.locator(".cm-fault").evaluate((words) => getComputedStyle(words).textDecoration), /wavy/);
    assert.equal(await page.locator(".cm-fault-gutter").getByText("!").count(), 1);
    assert.equal(await field(page).getAttribute("aria-invalid"), "true");
    const described = await field(page).getAttribute("aria-describedby");
    assert.match((await page.locator(`#${described}`).textContent()) ?? "", /found 0/);
    assert.deepEqual(await drawn(page), before);
    assert.equal((await page.getByRole("alert").textContent())?.trim(), "");
    // It goes when it is put right, and the text can be used.
    await page.keyboard.press("Backspace");
    await page.keyboard.type("5");
    await said(page, "No errors.").waitFor();
    assert.equal(await field(page).getAttribute("aria-invalid"), null);
    await page.keyboard.press("Control+Enter");
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length !== 12);
    await statusIs(page, "optimal");
  }));

test("broken JSON has its line, and names stay text", () =>
  onText(async (page) => {
    const hostile = '<img src=x onerror="document.title=1">';
    await put(page, `{\n  "format": "gridworld",\n  "🏔": oops,\n  "x": 1\n}`);
    await said(page, "line 3, column 8").waitFor();
    assert.equal((await linesOf(page))[3]?.startsWith("["), true);
    await put(page, `{\n  "format": "gridworld",\n  ${JSON.stringify(hostile)}: 1\n}`);
    await said(page, hostile.slice(0, 12)).waitFor();
    assert.equal((await linesOf(page))[3]?.startsWith("["), true);
    assert.equal(await page.locator(".cm-fault").first().textContent(), JSON.stringify(hostile));
    assert.equal(await page.locator("img").count(), 0);
  }));

test("the keyboard alone finds an error, puts it right, uses the text and leaves the field", () =>
  onText(async (page) => {
    await field(page).focus();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("x");
    await said(page, "Error").waitFor();
    await page.keyboard.press("Control+End");
    await page.keyboard.press("F8");
    await page.keyboard.press("Delete");
    await said(page, "No errors.").waitFor();
    await textIs(page, small);
    // Tab indents, until Escape was pressed.
    await page.keyboard.press("Control+Home");
    await page.keyboard.press("Tab");
    await textIs(page, `  ${small}`);
    await page.keyboard.press("Control+Enter");
    await page.waitForFunction(() => document.querySelector<HTMLButtonElement>(".document .actions button[disabled]"));
    await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    await page.waitForFunction(() => !document.activeElement?.classList.contains("text-field"));
    await textIs(page, `  ${small}`);
    // The page's keys are letters in the field, and its undo is the field's own.
    await field(page).focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.type("?");
    assert.equal(await page.getByRole("dialog").isVisible(), false);
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    await textIs(page, small);
    await statusIs(page, "optimal");
  }));

test("the text follows the page, but what was begun stays until it is told to go", () =>
  onText(async (page) => {
    const note = page.getByText("The problem on the page is another one by now.");
    await retype(page, "G2", "Gate");
    assert.equal(await note.isVisible(), false);
    await dragMouse(page, "actor", [
      [3, 0],
      [3, 1],
    ]);
    await note.waitFor();
    const mine = small.replace("G2", "Gate");
    await textIs(page, mine);
    // Another tab and back: it is as it was, and its undo too.
    await openTab(page, "Solve");
    await openTab(page, "Document");
    await textIs(page, mine);
    await press(page, "Show the page’s problem");
    const dragged = small.replace('"cell": [3, 0]', '"cell": [3, 1]');
    await textIs(page, dragged);
    await note.waitFor({ state: "hidden" });
    await field(page).focus();
    await page.keyboard.press("Control+z");
    await textIs(page, mine);
    await dragMouse(page, "actor", [
      [3, 1],
      [3, 2],
    ]);
    await note.waitFor();
    await press(page, "Keep my text");
    await note.waitFor({ state: "hidden" });
    await textIs(page, mine);
    // Undoing the edit on the page leaves the text, undoing the typing gives the page's.
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await note.waitFor();
    await textIs(page, mine);
    await press(page, "Undo typing");
    await textIs(page, dragged);
    // And then it follows again.
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await textIs(page, small);
  }));

test("a text that is used is one step for the page's undo", () =>
  onText(async (page) => {
    await retype(page, "G2", "Gate");
    await retype(page, "G1", "Good");
    await put(page, small.replaceAll("G1", "Good").replaceAll("G2", "Gate"));
    await said(page, "No errors.").waitFor();
    await field(page).press("Control+Enter");
    await page.locator("[data-goal=Gate]").first().waitFor();
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await page.locator("[data-goal=G2]").first().waitFor();
    await textIs(page, small);
    await page.getByRole("button", { name: "Redo", exact: true }).click();
    await page.locator("[data-goal=Gate]").first().waitFor();
    await textIs(page, small.replaceAll("G1", "Good").replaceAll("G2", "Gate"));
  }));

test("a document can be begun from a template, which the core takes", () =>
  onText(async (page) => {
    for (const { title, text } of templates) {
      assert.equal(taken(text), true, title);
      await page.locator("summary", { hasText: "New" }).click();
      await page.getByRole("button", { name: new RegExp(`^${title}`) }).click();
      await textIs(page, text);
      await said(page, "No errors.").waitFor();
    }
    await field(page).focus();
    for (const _ of templates) await page.keyboard.press("Control+z");
    await textIs(page, small);
  }));

test("JSON is put in order as the project writes it, where it can be read", () =>
  onText(async (page) => {
    await put(page, grid());
    await press(page, "Format");
    await textIs(page, small);
    // What the browser would read, and lose something of, stays and is shown.
    const twice = grid().replace('"width":4', '"width":4,"width":5');
    await put(page, twice);
    await said(page, "for the second time").waitFor();
    await press(page, "Format");
    await textIs(page, twice);
    await put(page, "{\n}}");
    await press(page, "Format");
    await textIs(page, "{\n}}");
  }));

test("a large document does not stop the page, in many lines or in one", () =>
  onText(async (page) => {
    const cells = Array.from({ length: 110_000 }, (_, index) => `[${index % 4}, 0]`);
    for (const [between, line] of [
      [", ", 1],
      [",\n", 110_000],
    ] as const) {
      await field(page).focus();
      await page.keyboard.press("Control+a");
      await paste(page, grid({ walls: 0 }).replace('"walls":0', `"walls":[${cells.join(between)}]`));
      await page.keyboard.press("Control+End");
      await page.keyboard.type("x");
      await said(page, new RegExp(`line ${line}, column`)).waitFor();
      await page.keyboard.press("F8");
      await page.keyboard.press("Delete");
      await said(page, /which is a wall/).waitFor();
    }
  }));

test("a text that was begun says nothing while it is checked for a problem without end", () =>
  onText(async (page) => {
    await put(page, endless());
    await said(page, "No errors.").waitFor();
  }));

test("axe finds no barrier in the text, with and without errors, light and dark", () =>
  onText(
    async (page) => {
      const assertNone = (state: string) => assertNoBarrier(page, state, { dark: true });
      await assertNone("no error");
      await put(page, small.replace('"width": 4', '"width": []'));
      await said(page, "width").waitFor();
      await assertNone("an error");
      await page.locator("summary", { hasText: "New" }).click();
      await assertNone("the menu of new documents");
      await page.getByRole("button", { name: /^PDDL/ }).click();
      await press(page, "PDDL");
      await put(page, "(define (problem)\n)", "Problem (PDDL)");
      await said(page, "problem, line").waitFor();
      await assertNone("an error in PDDL");
    },
    { reducedMotion: "reduce" },
  ));

test("the text fits a narrow screen", () =>
  onText(
    async (page) => {
      await put(page, small.replace('"width": 4', `"width": "${"x".repeat(300)}"`));
      await said(page, "width").waitFor();
      const overflow = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert((await overflow()) <= 0);
      await page.locator("summary", { hasText: "New" }).click();
      assert((await overflow()) <= 0);
      await page.getByRole("button", { name: /^PDDL/ }).click();
      await press(page, "PDDL");
      await field(page, "Domain (PDDL)").waitFor();
      assert((await overflow()) <= 0);
    },
    { viewport: { width: 320, height: 740 } },
  ));

test("the editor is fetched with its tab, and not before", () =>
  visit(async ({ page, requests }) => {
    await statusIs(page, "optimal");
    const editor = () => requests.filter((address) => address.includes("document-form"));
    assert.deepEqual(editor(), []);
    await openTab(page, "Document");
    await field(page).waitFor();
    assert.notEqual(editor().length, 0);
  }));
