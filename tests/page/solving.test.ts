// Asking the solvers: their options, cancelling, and a worker that is lost.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { example, solve } from "./support/core.js";
import { endless, grid } from "./support/documents.js";
import { attribute, choose, drawn, openTab, press, slider, statusIs, useDocument } from "./support/playground.js";

test("solver, bounds and plan length reach the core", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.getByLabel("Plan length").fill("14");
    await page.getByLabel("Friend keeps at most").fill("2");
    await press(page, "Solve");
    await page.getByText("among plans of 14 moves").waitFor();
    const { outcome } = solve(example, { solver: "exact", horizon: 14, j: 2 });
    assert.equal(await attribute(page, "data-gd"), String(outcome.goal_difference));
    assert.equal(await slider(page).getAttribute("max"), "14");

    await choose(page, "Solver", "baseline");
    await press(page, "Solve");
    await statusIs(page, "solved");
    assert.equal(await page.getByLabel("Plan length").count(), 0);
  }));

test("what no plan can do is proved to be so, and the start is shown", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.getByLabel("Plan length").fill("3");
    await press(page, "Solve");
    await statusIs(page, "infeasible");
    assert.equal(await attribute(page, "data-gd"), null);
    assert.equal(await attribute(page, "data-step"), "0");
    await page.getByText("It is proved that no plan does what was asked").waitFor();
  }));

test("options that make no sense are explained", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.getByLabel("Enemy keeps at least").fill("many");
    await press(page, "Solve");
    await statusIs(page, "error");
    await page.getByText("k must be a whole number; found “many”.").waitFor();
    await page.getByLabel("Enemy keeps at least").fill("99");
    await press(page, "Solve");
    await page.getByRole("alert").filter({ hasText: "99" }).waitFor();
    await statusIs(page, "error");
    await page.getByLabel("Enemy keeps at least").fill("");
    await press(page, "Solve");
    await statusIs(page, "optimal");
  }));

test("a search that takes long shows its progress, leaves the page alive, and can be cancelled", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, endless());
    await statusIs(page, "solving");
    await openTab(page, "Solve");
    await page.getByText(/states looked at/).waitFor();
    await press(page, "Cancel");
    await statusIs(page, "feasible", "limit");
  }));

test("a newer problem takes the place of a search under way", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, endless());
    await openTab(page, "Solve");
    await page.getByText(/states looked at/).waitFor();
    await useDocument(page, grid());
    await statusIs(page, "optimal");
    assert.equal(await page.locator('[data-board="actor"] [data-cell]').count(), 12);
  }));

test("a solver that does not obey a cancel is ended, and the next solve works", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await useDocument(page, endless());
      await openTab(page, "Solve");
      await page.getByText(/states looked at/).waitFor();
      await press(page, "Cancel");
      await statusIs(page, "feasible", "limit");
      await useDocument(page, grid());
      await statusIs(page, "optimal");
    },
    { before: withDeafWorkers },
  ));

test("a lost worker is replaced, says so, and leaves the problem as it was", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await useDocument(page, endless());
      await openTab(page, "Solve");
      await page.getByText(/states looked at/).waitFor();
      const before = await drawn(page);
      await page.evaluate("workers.at(-1).dispatchEvent(new ErrorEvent('error', { message: 'out of luck' }))");
      await page.getByRole("alert").filter({ hasText: "stopped unexpectedly (out of luck)" }).waitFor();
      await statusIs(page, "error");
      assert.deepEqual(await drawn(page), before);
      await choose(page, "Solver", "baseline");
      await press(page, "Solve");
      await statusIs(page, "solved");
    },
    { before: withKnownWorkers },
  ));

test("a core that can't be loaded is reported", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "error");
      await page.getByRole("alert").filter({ hasText: "The solver stopped unexpectedly" }).waitFor();
    },
    { before: (page) => page.route("**/*.wasm", (route) => route.abort()), quiet: false },
  ));

/** Workers that never hear of a cancel, as one in the middle of a long piece of work would not. */
const withDeafWorkers = (page: Page) =>
  page.addInitScript(`
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (message) {
      if (message.kind !== "cancel") post.call(this, message);
    };
  `);

/** Workers that a test can reach. */
const withKnownWorkers = (page: Page) =>
  page.addInitScript(`
    window.workers = [];
    const Original = window.Worker;
    window.Worker = class extends Original {
      constructor(...args) {
        super(...args);
        window.workers.push(this);
      }
    };
  `);
