// All solvers side by side: what each found, against the core; skipping, cancelling, and lost workers.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { SolveOptions } from "../../www/src/core.js";
import { assertNoBarrier } from "./support/barriers.js";
import { example, solve } from "./support/core.js";
import { endless, grid } from "./support/documents.js";
import { saved } from "./support/downloads.js";
import { difference } from "./support/fraction.js";
import { edit, opened } from "./support/opened.js";
import { attribute, openTab, press, slider, statusIs } from "./support/playground.js";
import { holdCore, withKnownWorkers } from "./support/workers.js";

const solvers: [title: string, options: SolveOptions][] = [
  ["Exact search", { solver: "exact" }],
  ["Integer program, belief flow", { solver: "ip", encoding: "belief-flow" }],
  ["Satisficing search", { solver: "satisficing" }],
  ["Heuristic search", { solver: "search" }],
  ["Baseline", { solver: "baseline" }],
  ["Obfuscate only", { solver: "obfuscate" }],
  ["Legible only", { solver: "legible" }],
  ["Integer program, paper", { solver: "ip", encoding: "paper" }],
];
const words = { optimal: "proved best", infeasible: "no plan" };

const row = (page: Page, title: string) =>
  page.locator(".comparison tbody tr").filter({ has: page.getByRole("rowheader", { name: title }) });
const complete = (page: Page) => page.getByText("The comparison is complete.").waitFor({ state: "attached" });

test("every solver's answer stands in the table, and choosing one shows its plan", () =>
  opened({ document: grid(), tab: "Compare" }, async (page) => {
    await page.getByLabel("Friend keeps at most").fill("1");
    await press(page, "Compare all solvers");
    await complete(page);
    for (const [title, options] of solvers) {
      const { outcome } = solve(grid(), { ...options, j: 1 });
      const cells = await row(page, title).getByRole("cell").allInnerTexts();
      const [answer, difference, enemy, friend, moves, time] = cells.map((text) => text.trim());
      const expected = { ...words, solved: options.solver === "baseline" ? "reaches the goal" : undefined };
      const said = expected[outcome.status as keyof typeof expected];
      const length = outcome.plan?.length ?? outcome.horizon;
      const of = options.solver === "ip" && outcome.status !== "solved" ? ` of ${length} moves` : "";
      if (said !== undefined) assert.equal(answer, said + of, title);
      else assert.match(answer ?? "", /^(meets the (friend’s bound|bounds)|reaches the goal)$/);
      assert.equal(difference, String(outcome.goal_difference ?? "–"), title);
      assert.equal(enemy, String(outcome.goals?.adversarial.length ?? "–"), title);
      assert.equal(friend, String(outcome.goals?.cooperative.length ?? "–"), title);
      assert.equal(moves, String(outcome.plan?.length ?? "–"), title);
      assert.match(time ?? "", /\d+(\.\d)? (ms|s)$/);
    }
    const baseline = solve(grid(), { solver: "baseline" }).outcome;
    await page.getByRole("button", { name: "Baseline" }).click();
    await page.getByText("On the boards: the plan of Baseline").waitFor();
    assert.equal(await page.getByRole("button", { name: "Baseline" }).getAttribute("aria-pressed"), "true");
    assert.equal(await slider(page).getAttribute("max"), String(baseline.plan?.length));
    assert.equal(await attribute(page, "data-gd"), String(baseline.goal_difference));
    await press(page, "Back to the solver’s plan");
    assert.equal(await page.getByRole("button", { name: "Baseline" }).getAttribute("aria-pressed"), "false");
  }));

test("a proof for plans of one length says so", () =>
  opened({ tab: "Compare" }, async (page) => {
    await press(page, "Compare all solvers");
    await page.getByLabel(/Ask for what the best plan reaches/).uncheck();
    await press(page, "Compare again");
    await row(page, "Integer program, belief flow").getByText("proved best of 14 moves").waitFor();
    await row(page, "Exact search").getByText("proved best", { exact: true }).waitFor();
  }));

test("without bounds of its own the comparison asks for what the best plan reaches, so that rows differ", () =>
  opened({ tab: "Compare" }, async (page) => {
    const { goals } = solve(example, { solver: "exact" }).outcome;
    const bounds = { k: goals?.adversarial.length ?? 0, j: goals?.cooperative.length ?? 0 };
    const offer = page.getByLabel(`Ask for what the best plan reaches: k = ${bounds.k}, j = ${bounds.j}`);
    assert(await offer.isChecked());
    await press(page, "Compare all solvers");
    await complete(page);
    await page.getByText(`Asked for: k = ${bounds.k}, j = ${bounds.j}.`).waitFor();
    const shown = async (title: string) => (await row(page, title).getByRole("cell").allInnerTexts()).slice(1, 5);
    const four = solvers.filter(([, { solver }]) => ["search", "baseline", "obfuscate", "legible"].includes(solver));
    const rows = await Promise.all(four.map(([title]) => shown(title)));
    for (const [index, [title, options]] of four.entries()) {
      const { outcome } = solve(example, { ...options, ...(options.solver === "baseline" ? {} : bounds) });
      const { goal_difference, goals: left, plan } = outcome;
      assert.deepEqual(
        rows[index]?.map((cell) => cell.trim()),
        [
          difference(goal_difference, JSON.parse(example).goals.length),
          left?.adversarial.length,
          left?.cooperative.length,
          plan?.length,
        ].map(String),
        title,
      );
    }
    assert(new Set(rows.map(String)).size > 1);
    await offer.uncheck();
    await page.getByText("These results are of an earlier problem, or of other bounds.").waitFor();
    await press(page, "Compare again");
    await complete(page);
    await page.getByText("Asked for: plans of any length, without bounds.").waitFor();
    await page.getByLabel("Friend keeps at most").fill("2");
    assert.equal(await offer.count(), 0);
  }));

test("the comparison is saved for spreadsheets and for programs", () =>
  opened({ document: grid(), tab: "Compare" }, async (page) => {
    await page.getByLabel("Friend keeps at most").fill("1");
    await press(page, "Compare all solvers");
    await complete(page);
    const [csv, json] = [await saved(page, "Save as CSV"), await saved(page, "Save as JSON")];
    assert.deepEqual([csv.name, json.name], ["problem-comparison.csv", "problem-comparison.json"]);
    const lines = csv.text.trimEnd().split("\r\n");
    const records = JSON.parse(json.text);
    assert.equal(lines.length, solvers.length + 1);
    assert.equal(records.length, solvers.length);
    for (const [index, [title, options]] of solvers.entries()) {
      const { outcome } = solve(grid(), { ...options, ...(options.solver === "baseline" ? {} : { j: 1 }) });
      const record = records[index];
      assert.equal(record.title, title);
      const kept = options.solver !== "baseline" && options.solver !== "obfuscate" ? 1 : undefined;
      assert.equal(record.options.j, kept, title);
      assert.deepEqual([record.outcome.status, record.outcome.plan], [outcome.status, outcome.plan]);
      const cells = lines[index + 1]?.split(",") ?? [];
      assert.equal(cells[0], options.solver);
      assert.equal(cells[3], kept === undefined ? "" : "1");
      assert.deepEqual(cells.slice(6, 8), [outcome.status, String(outcome.goal_difference ?? "")]);
      assert.equal(cells.at(-1), outcome.plan?.join(" ") ?? "");
    }
  }));

test("results of an earlier problem are marked and can't be chosen", () =>
  opened({ document: grid(), tab: "Compare" }, async (page) => {
    await press(page, "Compare all solvers");
    await complete(page);
    assert.equal(await page.getByRole("button", { name: "Baseline" }).count(), 1);
    await edit(page, grid({ start: [0, 1] }));
    await page.getByText("These results are of an earlier problem, or of other bounds.").waitFor();
    assert.equal(await page.getByRole("button", { name: "Baseline" }).count(), 0);
    await press(page, "Compare again");
    await complete(page);
    const { outcome } = solve(grid({ start: [0, 1] }), { solver: "baseline" });
    assert.equal(await row(page, "Baseline").getByRole("cell").nth(4).innerText(), String(outcome.plan?.length));
    await page.getByRole("button", { name: "Raise k" }).click();
    await page.getByText("These results are of an earlier problem, or of other bounds.").waitFor();
  }));

test("one is skipped with its best plan kept, the rest is cancelled, and the live answers go on meanwhile", () =>
  opened({ document: endless(), stopped: true, tab: "Compare" }, async (page) => {
    await page.getByLabel(/Ask for what the best plan reaches/).uncheck();
    await page.getByLabel("Each may take").selectOption({ label: "as long as it likes" });
    await press(page, "Compare all solvers");
    await page.getByText(/states looked at/).waitFor();
    await press(page, "Skip this one");
    await row(page, "Exact search").getByText("best found (skipped)").waitFor();
    await page.getByRole("button", { name: "Exact search" }).waitFor();
    await row(page, "Integer program, belief flow").getByText("proved best").waitFor();
    await complete(page);
    // A newer problem ends what is at work for the old one.
    await press(page, "Compare again");
    await row(page, "Exact search").getByText("at work…").waitFor();
    await edit(page, grid());
    await statusIs(page, "optimal");
    await page.getByText("These results are of an earlier problem, or of other bounds.").waitFor();
    await edit(page, endless());
    await page.locator('[data-board="actor"] [data-cell="23,23"]').waitFor();
    await press(page, "Compare again");
    await page
      .locator(".at-work")
      .getByText(/states looked at/)
      .waitFor();
    await press(page, "Cancel");
    await row(page, "Exact search").getByText("best found (cancelled)").waitFor();
    await page.getByText("The comparison was cancelled.").waitFor({ state: "attached" });
    assert.equal(await page.getByText("The comparison is complete.").count(), 0);
    await row(page, "Baseline").getByText("not run").waitFor();
  }));

test("one that takes longer than it may is stopped, and says so", () =>
  opened({ document: endless(), tab: "Compare" }, async (page) => {
    await page.locator('[data-board="actor"] [data-cell="23,23"]').waitFor();
    await page.getByLabel("Each may take").selectOption({ label: "2 seconds" });
    await press(page, "Compare all solvers");
    await row(page, "Exact search").getByText("best found (out of time)").waitFor();
    await complete(page);
  }));

test("time that a worker takes to load is not taken from the time a solver may take", () =>
  opened({ tab: "Compare", before: (page) => page.clock.install() }, async (page) => {
    await page.getByLabel("Each may take").selectOption({ label: "2 seconds" });
    const { asked, release } = await holdCore(page);
    await press(page, "Compare all solvers");
    await asked;
    await page.clock.runFor(20_000);
    release();
    await row(page, "Exact search").getByText("proved best").waitFor();
    await row(page, "Baseline").getByText("reaches the goal").waitFor();
  }));

test("a lost worker of the comparison is told, and the others run", () =>
  opened({ document: endless(), tab: "Solve", before: withKnownWorkers }, async (page) => {
    await page.getByText(/states looked at/).waitFor();
    await press(page, "Cancel");
    await statusIs(page, "feasible");
    await openTab(page, "Compare");
    await page.getByLabel(/Ask for what the best plan reaches/).uncheck();
    await press(page, "Compare all solvers");
    await page
      .locator(".at-work")
      .getByText(/states looked at/)
      .waitFor();
    await page.evaluate("lastSolver.dispatchEvent(new ErrorEvent('error', { message: 'out of luck' }))");
    await page.getByRole("alert").filter({ hasText: "The solver stopped unexpectedly (out of luck)" }).waitFor();
    await complete(page);
    await row(page, "Baseline").getByText("reaches the goal").waitFor();
    assert.equal(await attribute(page, "data-status"), "feasible");
  }));

for (const width of [320, 1280]) {
  test(`the table stays in a screen ${width} pixels wide and has no barrier`, () =>
    opened(
      { document: grid(), tab: "Compare", viewport: { width, height: 740 }, reducedMotion: "reduce" },
      async (page) => {
        await press(page, "Compare all solvers");
        await complete(page);
        await page.getByRole("button", { name: "Baseline" }).click();
        await page.getByText("On the boards:").waitFor();
        assert((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
        await assertNoBarrier(page, "the table of the solvers", { within: ".workbench", dark: true });
      },
    ));
}
