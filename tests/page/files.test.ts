// Documents as files: opened, dropped, saved, and typed in the document's tab.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { LARGEST_DOCUMENT } from "../../www/src/problem/limits.js";
import { visit } from "./support/browser.js";
import { replay, solve } from "./support/core.js";
import { grid } from "./support/documents.js";
import { saved } from "./support/downloads.js";
import { type Dropped, drop } from "./support/drop.js";
import { documentOf } from "./support/gallery.js";
import { dragMouse } from "./support/hands.js";
import { drawn, openTab, press, statusIs } from "./support/playground.js";
import { field, textIs } from "./support/text.js";

const name = "<img src=x onerror=alert(1)>";
const hostile = grid({
  goals: [
    { name, cell: [3, 0] },
    { name: "G2", cell: [0, 0] },
  ],
  true_goal: name,
});

const cells = (page: Page, count: number) =>
  page.waitForFunction(
    (wanted) => document.querySelectorAll('[data-board="actor"] [data-cell]').length === wanted,
    count,
  );

const jsonFile = (text: string, called = "problem.json") => ({
  name: called,
  mimeType: "application/json",
  buffer: Buffer.from(text),
});

const alert = (page: Page) => page.getByRole("alert").first();

test("a file dropped anywhere is opened; while it is dragged the page shows where it goes", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const sign = page.getByText("Drop the problem document here");
    for (const [on, width] of [
      ["h1", 5],
      [".stepper", 6],
    ] as const) {
      const file = { name: "a.json", text: grid({ width }) };
      await drop(page, on, { files: [file] }, () => sign.waitFor());
      await sign.waitFor({ state: "hidden" });
      await cells(page, width * 3);
      await statusIs(page, "optimal");
    }
  }));

test("the sign goes when the file is dragged away again", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const sign = page.getByText("Drop the problem document here");
    const data = await page.evaluateHandle(() => {
      const transfer = new DataTransfer();
      transfer.items.add(new File(["{}"], "a.json"));
      return transfer;
    });
    await page.dispatchEvent("h1", "dragenter", { dataTransfer: data });
    await sign.waitFor();
    await page.dispatchEvent("h1", "dragleave", { dataTransfer: data });
    await sign.waitFor({ state: "hidden" });
  }));

test("what is no single document is said, and the page stays as it was", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    // Where a problem that is opened again is shown as well.
    await press(page, "Last step");
    const before = await drawn(page);
    const file = { name: "a.json", text: grid() };
    const cases: [Dropped, RegExp][] = [
      [{ files: [file, file, file] }, /3 files/],
      [{ text: "hello" }, /no file/],
      [{ files: [{ name: "notes.txt", text: "Dear all" }] }, /line 1/],
      [{ files: [{ name: "empty.json", text: "" }] }, /\S+ \S+/],
      [{ files: [{ name: "big.json", text: " ".repeat(LARGEST_DOCUMENT + 1) }] }, /“big.json” is too large/],
    ];
    for (const [what, words] of cases) {
      await drop(page, "main", what);
      await alert(page).getByText(words).waitFor();
      assert.deepEqual(await drawn(page), before);
      await press(page, "Next problem");
      await statusIs(page, "optimal");
      await press(page, "Problem before");
      await statusIs(page, "optimal");
    }
  }));

test("text can still be dropped into the text field", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    await field(page).waitFor();
    const inText = await page.evaluate(() => {
      const transfer = new DataTransfer();
      transfer.setData("text/plain", "what was dropped");
      const event = new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true, composed: true });
      const content = document.querySelector(".text-field")?.shadowRoot?.querySelector(".cm-content");
      content?.dispatchEvent(event);
      // The field takes it; the page would have refused it.
      return content?.textContent?.includes("what was dropped");
    });
    assert.equal(inText, true);
    await statusIs(page, "optimal");
  }));

test("names in a document are text, from file and drop alike", () =>
  visit(async ({ page }) => {
    page.on("dialog", () => assert.fail("a script ran"));
    await statusIs(page, "optimal");
    const shown = async () => {
      await page.getByRole("rowheader", { name }).waitFor();
      await statusIs(page, "optimal");
      for (const tab of ["Steps", "Edit", "Compare", "Trade-off", "Play", "Document"]) {
        await openTab(page, tab);
        assert.equal(await page.locator("img").count(), 0, tab);
      }
    };
    await openTab(page, "Document");
    await page.getByLabel("Open a file").setInputFiles(jsonFile(hostile));
    await shown();
    await press(page, "Next problem");
    await statusIs(page, "optimal");
    await drop(page, "body", { files: [{ name: `${name}.json`, text: hostile }] });
    await shown();
    await drop(page, "body", { files: [{ name: `${name}.json`, text: " ".repeat(LARGEST_DOCUMENT + 1) }] });
    await alert(page).getByText("too large").waitFor();
    assert.equal(await page.locator("img").count(), 0);
  }));

test("the saved document is the one that is open, and runs in the core", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    const first = await saved(page, "Save as a file");
    assert.deepEqual([first.name, first.text], ["eight-by-eight.json", documentOf("eight-by-eight")]);

    // After an edit it is the edited one.
    await dragMouse(page, "actor", [
      [7, 4],
      [7, 5],
    ]);
    await page.getByText("An edited problem").waitFor();
    await statusIs(page, "optimal");
    const edited = await saved(page, "Save as a file");
    assert.notEqual(edited.text, first.text);
    const { outcome } = solve(edited.text, { solver: "exact" });
    assert.equal(outcome.status, "optimal");
    const shown = await page.locator("mo-copp-playground").getAttribute("data-gd");
    assert.equal(shown, String(outcome.goal_difference));
    assert.equal(replay(edited.text, outcome.plan ?? []).valid, true);

    // And it is opened again as it was saved.
    await press(page, "Next problem");
    await page.locator(".title", { hasText: "Head fake past a decoy" }).first().waitFor();
    await page.getByLabel("Open a file").setInputFiles(jsonFile(edited.text));
    await textIs(page, edited.text);
  }));
