// Other problems: what is wrong is said in words, and what is written is never taken for markup.
import assert from "node:assert/strict";
import { test } from "node:test";
import { visit } from "./support/browser.js";
import { solve } from "./support/core.js";
import { endless, explicit, grid } from "./support/documents.js";
import { assertDrawn, attribute, drawn, openTab, statusIs, useDocument } from "./support/playground.js";

test("another document is opened, solved and drawn", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, grid());
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 12);
    await statusIs(page, "optimal");
    const { outcome, trace } = solve(grid(), { solver: "exact", horizon: "any" });
    assert.equal(await attribute(page, "data-gd"), String(outcome.goal_difference));
    assertDrawn(await drawn(page), trace.steps.at(-1) ?? assert.fail(), "G1");
  }));

test("a document that can't be read is explained, and the page stays as it was", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const before = await drawn(page);
    const bad = ["{", '{"format": "chess"}', grid({ start: [9, 9] }), grid({ true_goal: "<b>G9</b>" }), ""];
    for (const document of bad) {
      await useDocument(page, document);
      await statusIs(page, "error");
      assert.match((await page.getByRole("alert").textContent()) ?? "", /\S+ \S+ \S+/);
      assert.equal(await page.getByRole("alert").locator("b").count(), 0);
      assert.deepEqual(await drawn(page), before);
    }
    await useDocument(page, grid());
    await statusIs(page, "optimal");
    assert.equal((await page.getByRole("alert").textContent())?.trim(), "");
  }));

test("a message can be closed, and the last answer is there again", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, grid({ start: [9, 9] }));
    await statusIs(page, "error");
    await page.getByRole("button", { name: "Close the message" }).click();
    await statusIs(page, "optimal");
    assert.equal((await page.getByRole("alert").first().textContent())?.trim(), "");
    assert.equal(await page.getByRole("button", { name: "Close the message" }).count(), 0);
  }));

test("a problem that takes long to solve is no edited one", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, endless());
    await page.getByText("Looking for a plan.").waitFor();
    await page.getByText("Your own problem").waitFor();
    assert.equal(await page.getByRole("button", { name: "Reset" }).getAttribute("aria-disabled"), "true");
  }));

test("a goal's name is text, whatever it holds", () =>
  visit(async ({ page }) => {
    const name = '<img src=x onerror="document.title=1">';
    const goals = [
      { name, cell: [3, 0] },
      { name: "G2", cell: [0, 0] },
    ];
    await statusIs(page, "optimal");
    await useDocument(page, grid({ goals, true_goal: name }));
    await page.getByRole("rowheader", { name }).waitFor();
    await statusIs(page, "optimal");
    assert.equal(await page.locator("img").count(), 0);
    assert.equal(await page.locator(`[data-goal=${JSON.stringify(name)}]`).count(), 6);
  }));

test("a file is opened like a text", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    const file = { name: "small.json", mimeType: "application/json", buffer: Buffer.from(grid()) };
    await page.getByLabel("Open a file").setInputFiles(file);
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 12);
    await statusIs(page, "optimal");
  }));

test("a problem without a grid is shown as text", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, explicit);
    await page.locator('[data-board="actor"] .state-name').waitFor();
    await statusIs(page, "optimal");
    assert.equal(await attribute(page, "data-gd"), "1");
    assert.equal(
      await page
        .locator('[data-board="actor"]')
        .textContent()
        .then((text) => text?.trim()),
      "s1",
    );
    assert.equal(await page.locator('[data-board="adversarial"] [data-believed]').count(), 2);
    assert.equal(await page.locator('tr[data-goal="G2"]').getAttribute("data-cooperative"), "dead");
  }));
