// The whole state comes back from a link, whatever solver answered, and whatever the page was used for before.
import assert from "node:assert/strict";
import { test } from "node:test";
import { isDeepStrictEqual } from "node:util";
import { pack } from "../../www/src/share/packed.js";
import { visit } from "./support/browser.js";
import { solve } from "./support/core.js";
import { grid } from "./support/documents.js";
import { documentOf } from "./support/gallery.js";
import { addressHolds, follow } from "./support/links.js";
import { attribute, choose, drawn, openTab, press, slider, statusIs, stepIs } from "./support/playground.js";

const gridworld = documentOf("eight-by-eight");
const asked: [title: string, form: Record<string, string>, status: string, document?: string][] = [
  ["exact search", { k: "1", j: "2", horizon: "7" }, "optimal"],
  ["integer program, belief flow", { solver: "ip", k: "1", horizon: "6", horizonStep: "1" }, "optimal"],
  ["integer program, paper", { solver: "ip", encoding: "paper", horizon: "7" }, "optimal"],
  ["satisficing search", { solver: "satisficing", k: "3", j: "1" }, "solved", gridworld],
  ["heuristic search", { solver: "search", k: "3", j: "1" }, "solved", gridworld],
  ["baseline", { solver: "baseline", horizon: "9" }, "solved"],
  ["obfuscate", { solver: "obfuscate", k: "4" }, "solved", gridworld],
  ["legible", { solver: "legible", j: "1" }, "solved", gridworld],
  ["no plan", { solver: "search", horizon: "4" }, "infeasible"],
];

for (const [title, form, status, problem = grid()] of asked) {
  test(`the whole state comes back from the link, ${title}`, () =>
    visit(async ({ page }) => {
      const link = `#${await pack(JSON.stringify({ document: problem, form, step: 0, tab: "solve" }))}`;
      await follow(page, link);
      await statusIs(page, "optimal", "infeasible");
      if (form.solver !== undefined) await press(page, "Solve");
      await page
        .getByText(
          /^(Exact search|Integer program|Satisficing search|Heuristic search|Baseline|Obfuscate only|Legible only): /,
        )
        .waitFor();
      await statusIs(page, status);
      if (status !== "infeasible") await slider(page).fill("2");
      await openTab(page, "Steps");
      const step = status === "infeasible" ? 0 : 2;
      const hash = await addressHolds(page, (state) => state.step === step && state.tab === "steps");
      const read = async () => {
        await openTab(page, "Solve");
        const answer = await page.locator(".result [role=status]").first().textContent();
        const fields = await page
          .locator(".solver input, .solver select")
          .evaluateAll((all) => all.map((field) => (field as HTMLInputElement).value));
        const attributes = [];
        for (const name of ["data-status", "data-step", "data-gd"]) attributes.push(await attribute(page, name));
        return { answer, fields, attributes, drawn: await drawn(page) };
      };
      const before = await read();
      // Where the page was used for something else, and where it opens for the first time.
      await choose(page, "Solver", form.solver === "baseline" ? "legible" : "baseline");
      await press(page, "Solve");
      await addressHolds(page, (state) => state.tab === "solve");
      await page.evaluate((other) => {
        location.hash = other;
      }, hash);
      for (const again of [false, true]) {
        if (again) await follow(page, hash);
        await page.getByRole("tab", { name: "Steps", selected: true }).waitFor();
        await statusIs(page, status);
        await stepIs(page, step);
        // The best possible is worked out when the answer is there, and is said then.
        for (let looks = 0; looks < 100 && !isDeepStrictEqual(await read(), before); looks += 1)
          await page.waitForTimeout(100);
        assert.deepEqual(await read(), before);
        await openTab(page, "Steps");
        assert.equal(await addressHolds(page, (state) => state.tab === "steps"), hash);
      }
    }));
}

test("the plan of a link is there while its solver is still at work", () =>
  visit(async ({ page }) => {
    const { outcome } = solve(gridworld, { solver: "exact" });
    const form = { solver: "ip", encoding: "paper", horizon: "16" };
    const state = { document: gridworld, form, answered: true, plan: outcome.plan, step: 5, mode: "plan" };
    await follow(page, `#${await pack(JSON.stringify(state))}`);
    await page.getByText("On the boards: the plan of the link.").waitFor();
    await page.waitForSelector('mo-copp-playground[data-status="solving"][data-step="5"][data-gd="1"]');
    await press(page, "Cancel");
    await statusIs(page, "feasible", "limit");
    await page.getByText("On the boards: the plan of the link.").waitFor();
    await stepIs(page, 5);
  }));
