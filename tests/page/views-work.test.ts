// The further domains at work: links, comparing, the trade-off, and a problem that is too large to be solved at once.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { unpack } from "../../www/src/share/packed.js";
import { visit } from "./support/browser.js";
import { solve } from "./support/core.js";
import { difference } from "./support/fraction.js";
import { documentOf } from "./support/gallery.js";
import { choose, openTab, press, slider, statusIs, stepIs } from "./support/playground.js";
import { board, drop, goTo, open } from "./support/views.js";

test("a link brings back the problem, the step and the tab", () =>
  open("logistics", async (page) => {
    await goTo(page, 4);
    await openTab(page, "Steps");
    const address = await addressAt(page, 4, "steps");
    await page.goto("about:blank");
    await page.goto(address);
    await stepIs(page, 4);
    await board(page, "actor").locator(".place-card").first().waitFor();
    await page.locator('[role="tab"][data-tab="steps"][aria-selected="true"]').waitFor();
    const { trace } = solve(documentOf("logistics"), { solver: "exact" });
    const states = await page.locator(".steps tbody tr td.count").allInnerTexts();
    // A goal difference is of a plan that is at its goal.
    const goals = JSON.parse(documentOf("logistics")).goals.length;
    const expected = trace.steps.flatMap(({ beliefs, goal_difference }, index) => [
      String(beliefs.adversarial.length),
      String(beliefs.cooperative.length),
      index === trace.steps.length - 1 ? difference(goal_difference, goals) : "",
    ]);
    assert.deepEqual(states, expected);
  }));

/** The address, once it holds this step and this tab. */
async function addressAt(page: Page, step: number, tab: string): Promise<string> {
  for (;;) {
    const hash = await page.evaluate(() => location.hash);
    const state = await unpack(hash.slice(1)).then(JSON.parse, () => null);
    if (state?.step === step && state.tab === tab) return page.url();
    await page.waitForFunction((before) => location.hash !== before, hash);
  }
}

test("all solvers are compared, and the trade-off is drawn", () =>
  open("logistics", async (page) => {
    await openTab(page, "Compare");
    await page.getByLabel("Each may take").selectOption({ index: 0 });
    await press(page, "Compare all solvers");
    await page.getByText("The comparison is complete.").waitFor({ state: "attached" });
    const row = page.locator(".comparison tbody tr").filter({ hasText: "Exact search" });
    assert.match(await row.innerText(), /proved best/);
    await openTab(page, "Trade-off");
    const points = page.getByRole("group", { name: "Goals possible for the enemy against" }).getByRole("button");
    await points.first().waitFor();
    const { outcome } = solve(documentOf("logistics"), { solver: "exact", pareto: true });
    assert.equal(await points.count(), outcome.pareto?.length);
  }));

test("a large problem is shown while it is worked on, can be cancelled, and its search ends with a summary", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    // Its proof takes long: `mo-copp generate logistics --seed 19`.
    const text = readFileSync(new URL("support/logistics-19.json", import.meta.url), "utf8");
    await drop(page, text);
    await board(page, "actor").locator(".thing-box.package").nth(5).waitFor();
    await press(page, "Cancel");
    await statusIs(page, "limit", "feasible");
    await choose(page, "Solver", "search");
    await page.getByLabel("Enemy keeps at least").fill("3");
    await page.getByLabel("Friend keeps at most").fill("3");
    await press(page, "Solve");
    await statusIs(page, "solved");
    const steps = Number(await slider(page).getAttribute("max"));
    assert(steps > 14);
    const told = await board(page, "adversarial").getAttribute("aria-label");
    const states = Number(/holds ([\d,]+) states/.exec(told ?? "")?.[1]?.replaceAll(",", ""));
    assert(states > 100, told ?? "");
    await board(page, "adversarial").locator(".summary li").first().waitFor();
  }));
