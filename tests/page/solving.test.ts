// Asking the solvers: their options, cancelling, and a worker that is lost.
import assert from "node:assert/strict";
import { test } from "node:test";
import { visit } from "./support/browser.js";
import { advise, example, solve } from "./support/core.js";
import { endless, grid } from "./support/documents.js";
import { difference } from "./support/fraction.js";
import { edit, opened } from "./support/opened.js";
import { attribute, choose, drawn, openTab, press, slider, statusIs, useDocument } from "./support/playground.js";
import { withDeafWorkers, withKnownWorkers } from "./support/workers.js";

test("exact answers follow every change at once, within the bounds", () =>
  opened({}, async (page) => {
    assert.equal(await page.getByRole("button", { name: "Solve", exact: true }).count(), 0);
    await page.getByLabel("Plan length").fill("14");
    await page.getByLabel("Friend keeps at most").fill("2");
    await page.getByText("proved best of the plans of 14 moves within the bounds").waitFor();
    const { outcome } = solve(example, { solver: "exact", horizon: 14, j: 2 });
    assert.equal(await attribute(page, "data-gd"), String(outcome.goal_difference));
    assert.equal(await slider(page).getAttribute("max"), "14");
    await page.getByText("Best of 14 moves within bounds: 2/3").waitFor();
  }));

test("the command for what the form asks can be copied", () =>
  opened({ permissions: ["clipboard-read", "clipboard-write"] }, async (page) => {
    await page.getByLabel("Plan length").fill("16");
    await page.getByLabel("Friend keeps at most").fill("2");
    await statusIs(page, "optimal");
    const command = "mo-copp solve eight-by-eight.json --solver exact --horizon 16 --j 2";
    await page.getByText(command, { exact: true }).waitFor();
    await press(page, "Copy the command");
    await page.getByText("Copied.", { exact: true }).waitFor();
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), command);
    await choose(page, "Solver", "ip");
    await page.getByLabel("Raise by").fill("2");
    const encoding = "--encoding belief-flow --horizon 16 --horizon-step 2 --j 2";
    await page.getByText(`mo-copp solve eight-by-eight.json --solver ip ${encoding}`, { exact: true }).waitFor();
  }));

test("numbers are stepped up and down between the limits that the scene sets", () =>
  opened({}, async (page) => {
    const k = page.getByLabel("Enemy keeps at least");
    const [raise, lower] = [
      page.getByRole("button", { name: "Raise k" }),
      page.getByRole("button", { name: "Lower k" }),
    ];
    // Less than no bound can't be asked for.
    assert(await lower.isDisabled());
    await k.press("ArrowDown");
    assert.equal(await k.inputValue(), "");
    for (const expected of ["2", "3", "4"]) {
      await raise.click();
      assert.equal(await k.inputValue(), expected);
    }
    assert(await raise.isDisabled());
    await k.press("ArrowDown");
    assert.equal(await k.inputValue(), "3");
    for (const expected of ["2", "1", ""]) {
      await lower.click();
      assert.equal(await k.inputValue(), expected);
    }
    const j = page.getByLabel("Friend keeps at most");
    const [more, fewer] = [
      page.getByRole("button", { name: "Raise j" }),
      page.getByRole("button", { name: "Lower j" }),
    ];
    assert(await more.isDisabled());
    for (const expected of ["3", "2", "1"]) {
      await fewer.click();
      assert.equal(await j.inputValue(), expected);
    }
    assert(await fewer.isDisabled());
    for (const expected of ["2", "3", "4", ""]) {
      await more.click();
      assert.equal(await j.inputValue(), expected);
    }
    await page.getByRole("button", { name: "One move shorter" }).click();
    // It begins at the length of the plan shown.
    const { outcome } = solve(example, { solver: "exact" });
    assert.equal(await page.getByLabel("Plan length").inputValue(), String(outcome.plan?.length));
  }));

test("a number that can't be used is explained and changes nothing", () =>
  opened({}, async (page) => {
    const before = await attribute(page, "data-gd");
    const k = page.getByLabel("Enemy keeps at least");
    await k.fill("many");
    await page.getByText("A whole number of goals from 1 to 4; empty means “no bound”.").waitFor();
    assert.equal(await k.getAttribute("aria-invalid"), "true");
    assert.equal(await attribute(page, "data-gd"), before);
    assert.equal(await attribute(page, "data-status"), "optimal");
    await k.press("Tab");
    assert.equal(await k.inputValue(), "");
    await k.fill("99");
    await k.press("Tab");
    assert.equal(await k.inputValue(), "4");
    assert.equal(await page.getByText("A whole number of goals").count(), 0);
  }));

test("bounds that an edit leaves no goals for are brought down", () =>
  opened({}, async (page) => {
    await page.getByLabel("Enemy keeps at least").fill("4");
    await page.getByText("Best within bounds: 1").waitFor();
    await useDocument(page, example);
    await openTab(page, "Solve");
    await page.getByLabel("Enemy keeps at least").fill("4");
    await page.getByLabel("Friend keeps at most").fill("4");
    const document = JSON.parse(example);
    document.goals.pop();
    await edit(page, JSON.stringify(document));
    await page.getByText("(3 for the enemy − 1 for the friend) ÷ (3 − 1)").waitFor();
    assert.equal(await page.getByLabel("Enemy keeps at least").inputValue(), "3");
    assert.equal(await page.getByLabel("Friend keeps at most").inputValue(), "");
    assert.equal(await attribute(page, "data-status"), "optimal");
  }));

test("other solvers run on Solve; edits show the best possible and offer the solver again", () =>
  opened({}, async (page) => {
    await choose(page, "Solver", "baseline");
    assert.equal(await page.getByLabel("Enemy keeps at least").count(), 0);
    await press(page, "Solve");
    await statusIs(page, "solved");
    const { outcome } = solve(example, { solver: "baseline" });
    assert.equal(await attribute(page, "data-gd"), String(outcome.goal_difference));
    await page.getByText("Baseline: reaches the goal.").waitFor();
    await page.getByText("Best possible: 1 · this plan: 2/3").waitFor();
    assert.equal(await page.getByRole("button", { name: /Solve again/ }).count(), 0);

    const document = JSON.parse(example);
    document.start = [0, 6];
    for (const observer of Object.values<{ initial_belief: unknown }>(document.observers))
      observer.initial_belief = [[0, 6]];
    await edit(page, JSON.stringify(document));
    await statusIs(page, "optimal");
    await page.getByText("Exact search: proved best of the plans of every length.").waitFor();
    const edited = JSON.stringify(document);
    assert.equal(await attribute(page, "data-gd"), String(solve(edited, { solver: "exact" }).outcome.goal_difference));
    await press(page, "Solve again with Baseline");
    await statusIs(page, "solved");
    const again = solve(edited, { solver: "baseline" }).outcome;
    assert.equal(await attribute(page, "data-gd"), String(again.goal_difference));
  }));

test("the best possible is found beside a solver that was faster than it", () =>
  opened({}, async (page) => {
    await choose(page, "Solver", "baseline");
    const document = JSON.parse(example);
    document.walls.pop();
    await page.evaluate(`{
      const { playground } = document.querySelector("mo-copp-playground")[Symbol.for("mo-copp view")];
      playground.edits.apply(${JSON.stringify(document)});
      void playground.solving.solve();
    }`);
    await statusIs(page, "solved");
    const { goal_difference } = solve(JSON.stringify(document), { solver: "exact" }).outcome;
    await page.getByText(`Best possible: ${goal_difference}`).waitFor();
    assert.equal(await attribute(page, "data-status"), "solved");
  }));

for (const encoding of ["belief-flow", "paper"] as const) {
  test(`the integer program, ${encoding}, raises the length by the step`, () =>
    opened({ document: grid(), tab: "Solve" }, async (page) => {
      await choose(page, "Solver", "ip");
      await choose(page, "Encoding", encoding);
      await page.getByLabel("Plan length").fill("3");
      await page.getByText("No plan can do what is asked").waitFor();
      await page.getByLabel("Raise by").fill("2");
      await press(page, "Solve");
      await page.getByText(/^Integer program: proved best/).waitFor();
      const { outcome } = solve(grid(), { solver: "ip", encoding, horizon: 3, horizon_step: 2 });
      assert.equal(outcome.plan?.length, 5);
      assert.equal(await slider(page).getAttribute("max"), "5");
      assert.equal(await attribute(page, "data-gd"), String(outcome.goal_difference));
    }));
}

test("what no plan can do is proved to be so, the start is shown, and a longer plan is offered", () =>
  opened({}, async (page) => {
    await page.getByLabel("Plan length").fill("3");
    await statusIs(page, "infeasible");
    assert.equal(await attribute(page, "data-gd"), null);
    assert.equal(await attribute(page, "data-step"), "0");
    await page.getByText("The true goal is 14 moves away: no plan is shorter.").waitFor();
    const [remedy] = advise(example, { solver: "exact", horizon: 3 }).remedies;
    assert.deepEqual([remedy?.change, remedy?.value], ["horizon", 14]);
    await press(page, "A longer plan: 14 moves");
    await statusIs(page, "optimal");
    assert.equal(await page.getByLabel("Plan length").inputValue(), "14");
    assert.equal(await attribute(page, "data-gd"), String(remedy?.goal_difference));
  }));

test("every remedy for bounds that can't be kept is offered, and does", () =>
  opened({}, async (page) => {
    await page.getByLabel("Plan length").fill("14");
    await statusIs(page, "optimal");
    await page.getByLabel("Enemy keeps at least").fill("4");
    await statusIs(page, "infeasible");
    await page
      .getByText("No plan of exactly 14 moves reaches the true goal and keeps at least 4 goals possible for the enemy")
      .waitFor();
    const { remedies, complete } = advise(example, { solver: "exact", horizon: 14, k: 4 });
    assert(complete && remedies.length > 1);
    const offered = page.locator(".remedies button");
    await offered.first().waitFor();
    assert.equal(await offered.count(), remedies.length);
    for (const [index, { change, value, goal_difference }] of remedies.entries()) {
      await offered.nth(index).click();
      await statusIs(page, "optimal");
      const label = { horizon: "Plan length", k: "Enemy keeps at least", j: "Friend keeps at most" }[change];
      assert.equal(await page.getByLabel(label).inputValue(), String(value));
      assert.equal(await attribute(page, "data-gd"), String(goal_difference));
      await page.getByLabel("Plan length").fill("14");
      await page.getByLabel("Enemy keeps at least").fill("4");
      await page.getByLabel("Friend keeps at most").fill("");
      await statusIs(page, "infeasible");
    }
  }));

test("a goal that can't be reached is said to be so", () =>
  opened(
    {
      document: grid({
        walls: [
          [2, 0],
          [3, 1],
        ],
      }),
    },
    async (page) => {
      await statusIs(page, "infeasible");
      await openTab(page, "Solve");
      await page.getByText("The true goal cannot be reached from the start, however long the plan.").waitFor();
      assert.equal(await page.locator(".remedies").count(), 0);
    },
  ));

test("a search that takes long shows its progress, leaves the page alive, and can be cancelled", () =>
  opened({ document: endless() }, async (page) => {
    await statusIs(page, "solving");
    await openTab(page, "Solve");
    await page.getByText(/states looked at/).waitFor();
    await page.getByText(/\d\.\d s$/).waitFor();
    await press(page, "Cancel");
    await statusIs(page, "feasible");
    await page.getByText("Exact search: best found.").waitFor();
    const found = difference(Number(await attribute(page, "data-gd")), JSON.parse(endless()).goals.length);
    await page.getByText(`Best found: ${found}`, { exact: true }).waitFor();
    await press(page, "Solve again");
    await statusIs(page, "solving");
    await press(page, "Cancel");
    await statusIs(page, "feasible");
  }));

test("the integer program tells its bound and its gap, and a cancel keeps the best plan", () =>
  opened({}, async (page) => {
    await choose(page, "Solver", "ip");
    await choose(page, "Encoding", "paper");
    await page.getByLabel("Plan length").fill("16");
    // The best possible is worked out first: a solve that is asked for before takes its place.
    await page.getByText("Best of 16 moves: 1").waitFor();
    await press(page, "Solve");
    await page.getByText(/nodes looked at, plans of 16 moves, .*at most 1 possible/).waitFor();
    await press(page, "Cancel");
    await statusIs(page, "feasible", "limit");
    await page.getByText(/^Integer program: (best found|stopped)/).waitFor();
    await page.getByText("Best of 16 moves: 1").waitFor();
  }));

test("a newer problem takes the place of a search under way", () =>
  opened({ document: endless(), tab: "Solve" }, async (page) => {
    await page.getByText(/states looked at/).waitFor();
    await useDocument(page, grid());
    await statusIs(page, "optimal");
    assert.equal(await page.locator('[data-board="actor"] [data-cell]').count(), 12);
  }));

test("a solver that does not obey a cancel is ended, and the next solve works", () =>
  opened({ document: endless(), tab: "Solve", before: withDeafWorkers }, async (page) => {
    await page.getByText(/states looked at/).waitFor();
    await press(page, "Cancel");
    await statusIs(page, "feasible", "limit");
    await useDocument(page, grid());
    await statusIs(page, "optimal");
  }));

test("a lost worker is replaced, says so, and leaves the problem as it was", () =>
  opened({ document: endless(), tab: "Solve", before: withKnownWorkers }, async (page) => {
    await page.getByText(/states looked at/).waitFor();
    const before = await drawn(page);
    // The first is that of the boards; the field for the text has one of its own.
    await page.evaluate("workers[0].dispatchEvent(new ErrorEvent('error', { message: 'out of luck' }))");
    await page.getByRole("alert").filter({ hasText: "stopped unexpectedly (out of luck)" }).waitFor();
    await statusIs(page, "error");
    assert.deepEqual(await drawn(page), before);
    await choose(page, "Solver", "baseline");
    await press(page, "Solve");
    await statusIs(page, "solved");
  }));

test("an undo or a redo that is lost with its worker can be done again", () =>
  opened({ before: withKnownWorkers }, async (page) => {
    const shows = (cells: number) =>
      page.waitForFunction(
        (count) => document.querySelectorAll("[data-board=actor] [data-cell]").length === count,
        cells,
      );
    for (const height of [3, 4, 5]) {
      await useDocument(page, grid({ height }));
      await shows(4 * height);
      await statusIs(page, "optimal");
    }
    /** The next task is lost with its worker. */
    const lose = () =>
      page.evaluate(`
          const worker = workers[lost ?? 0];
          const post = worker.postMessage.bind(worker);
          worker.postMessage = (message) => {
            if (message.kind !== "solve") return post(message);
            window.lost = workers.length;
            worker.dispatchEvent(new ErrorEvent("error", { message: "out of luck" }));
          };`);
    await page.evaluate("window.lost = undefined");
    for (const [button, left, reached] of [
      ["Undo", 20, 16],
      ["Redo", 16, 20],
    ] as const) {
      await lose();
      await press(page, button);
      await page.getByRole("alert").filter({ hasText: "stopped unexpectedly (out of luck)" }).waitFor();
      await shows(left);
      await press(page, button);
      await shows(reached);
      await statusIs(page, "optimal");
    }
    await press(page, "Undo");
    await shows(16);
    await press(page, "Undo");
    await shows(12);
  }));

test("a core that can't be loaded is reported", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "error");
      await page.getByRole("alert").filter({ hasText: "The solver could not be started" }).waitFor();
    },
    { before: (page) => page.route("**/*.wasm", (route) => route.abort()), quiet: false },
  ));
