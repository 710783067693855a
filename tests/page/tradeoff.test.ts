// The trade-off: every reachable pair and the best of each length, against the core; choosing points by mouse, touch and
// keyboard; following edits.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNoBarrier } from "./support/barriers.js";
import { example, solve } from "./support/core.js";
import { endless, grid, laborious } from "./support/documents.js";
import { saved } from "./support/downloads.js";
import { difference, fraction } from "./support/fraction.js";
import { edit, opened } from "./support/opened.js";
import { attribute, openTab, press, slider, statusIs } from "./support/playground.js";
import { holdCore, withDeafWorkers, withKnownWorkers } from "./support/workers.js";

const pairs = (page: Page) => page.getByRole("group", { name: "Goals possible for the enemy against" });
const lengths = (page: Page) => page.getByRole("group", { name: "The best goal difference of each plan length" });
const names = (chart: ReturnType<typeof pairs>) =>
  chart.getByRole("button").evaluateAll((points) => points.map((point) => point.getAttribute("aria-label") ?? ""));

function expectedPairs(document: string): string[] {
  const { outcome } = solve(document, { solver: "exact", pareto: true });
  const goals = JSON.parse(document).goals.length;
  const best = Math.max(...(outcome.pareto ?? []).map((pair) => pair.adversarial - pair.cooperative));
  return (outcome.pareto ?? []).map(({ adversarial, cooperative, plan }) => {
    const ahead = adversarial - cooperative;
    return `${adversarial} possible for the enemy, ${cooperative} for the friend: goal difference ${fraction(ahead, goals - 1)} in ${plan.length} moves${ahead === best ? ", the best" : ""}`;
  });
}

/** The example with a friend who is told no more than the enemy: pairs all over the grid. */
const spread = (() => {
  const document = JSON.parse(example);
  document.observers.cooperative.sensor = document.observers.adversarial.sensor;
  return JSON.stringify(document);
})();

test("every pair that the core reaches is a point, and choosing one shows its plan", () =>
  opened({ document: spread, tab: "Trade-off" }, async (page) => {
    await pairs(page).waitFor();
    const expected = expectedPairs(spread);
    assert.equal(expected.length, 9);
    assert.deepEqual(await names(pairs(page)), expected);
    const { outcome } = solve(spread, { solver: "exact", pareto: true });
    for (const [index, pair] of (outcome.pareto ?? []).entries()) {
      const point = pairs(page).getByRole("button").nth(index);
      await point.locator(".area").click();
      await page
        .getByText(`a plan that leaves ${pair.adversarial} to the enemy, ${pair.cooperative} to the friend`)
        .waitFor();
      await point.and(page.locator('[aria-pressed="true"]')).waitFor();
      assert.equal(await attribute(page, "data-gd"), String((pair.adversarial - pair.cooperative) / 3));
      assert.equal(await slider(page).getAttribute("max"), String(pair.plan.length));
    }
    await page.getByText("The pairs as a table").click();
    const rows = page.locator(".twin").first().locator("tbody tr");
    assert.equal(await rows.count(), expected.length);
    await rows.first().getByRole("button").click();
    await pairs(page).getByRole("button").first().and(page.locator('[aria-pressed="true"]')).waitFor();
    await press(page, "Back to the solver’s plan");
    await page.getByText("On the boards:").waitFor({ state: "detached" });
  }));

test("the best of each length is a point, and lengths without a plan are marked", () =>
  opened({ tab: "Trade-off" }, async (page) => {
    await lengths(page).waitFor();
    const shortest = 14;
    const check = async (longest: number) => {
      const { outcome } = solve(example, { solver: "exact", lengths: longest });
      const points = outcome.lengths ?? [];
      const feasible = points.filter((point) => point.plan !== null);
      const best = Math.max(...feasible.map((point) => point.goal_difference ?? -1));
      assert.deepEqual(
        await names(lengths(page)),
        feasible.map(
          (point) =>
            `${point.length} moves: goal difference ${difference(point.goal_difference, JSON.parse(example).goals.length)}, ${point.adversarial} possible for the enemy, ${point.cooperative} for the friend${point.goal_difference === best ? ", the best" : ""}`,
        ),
      );
      const none = points.filter((point) => point.plan === null);
      assert.equal(
        await lengths(page).locator("path.none").count(),
        none.filter(({ length }) => length >= shortest - 2).length,
      );
      const twin = page.locator(".twin").last();
      assert.equal(await twin.locator("tbody tr").count(), points.length);
      assert.equal(await twin.getByText("no plan").count(), none.length);
      return feasible;
    };
    const feasible = await check(shortest + 12);
    assert.equal(feasible[0]?.length, shortest);
    await lengths(page).getByRole("button").first().locator(".area").click();
    await page.getByText("On the boards: the best plan of 14 moves").waitFor();
    assert.equal(await attribute(page, "data-gd"), String(feasible[0]?.goal_difference));
    assert.equal(await slider(page).getAttribute("max"), "14");
    await page.getByLabel("Up to").selectOption("24");
    await lengths(page)
      .getByRole("button", { name: /^38 moves/ })
      .waitFor();
    await check(shortest + 24);
  }));

test("pairs and lengths are saved for spreadsheets and for programs", () =>
  opened({ document: spread, tab: "Trade-off" }, async (page) => {
    await lengths(page).waitFor();
    await page.locator('.charts[aria-busy="false"]').waitFor();
    const { pareto = [] } = solve(spread, { solver: "exact", pareto: true }).outcome;
    const pairsText = (await saved(page, "Save as CSV", "Save the pairs")).text.trimEnd().split("\r\n");
    assert.equal(pairsText[0], "enemy goals,friend goals,goal difference,moves,plan");
    assert.deepEqual(
      pairsText.slice(1),
      pareto.map(
        ({ adversarial, cooperative, plan }) =>
          `${adversarial},${cooperative},${(adversarial - cooperative) / 3},${plan.length},${plan.join(" ")}`,
      ),
    );
    const pairsJson = JSON.parse((await saved(page, "Save as JSON", "Save the pairs")).text);
    assert.deepEqual(pairsJson.known, { kind: "all" });
    assert.deepEqual(
      pairsJson.pareto.map(({ plan }: { plan: string[] }) => plan),
      pareto.map(({ plan }) => plan),
    );
    const lengthsJson = JSON.parse((await saved(page, "Save as JSON", "Save the lengths")).text);
    const last = lengthsJson.lengths.at(-1).length;
    assert.deepEqual(lengthsJson.lengths, solve(spread, { solver: "exact", lengths: last }).outcome.lengths);
    const lengthsText = (await saved(page, "Save as CSV", "Save the lengths")).text.trimEnd().split("\r\n");
    assert.equal(lengthsText.length, last + 2);
  }));

test("the charts are used by keyboard alone", () =>
  opened({ tab: "Trade-off" }, async (page) => {
    await pairs(page).waitFor();
    await page.locator('.charts[aria-busy="false"]').waitFor();
    const step = await attribute(page, "data-step");
    await page.getByRole("tab", { name: "Trade-off" }).focus();
    const focused = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? "");
    await page.keyboard.press("Tab");
    assert.match(await focused(), /^4 possible for the enemy, 1 for the friend/);
    await page.keyboard.press("ArrowDown");
    assert.match(await focused(), /^3 possible for the enemy, 1 for the friend/);
    await page.keyboard.press("Home");
    assert.match(await focused(), /^1 possible for the enemy/);
    await page.keyboard.press("ArrowUp");
    assert.equal(await attribute(page, "data-step"), step);
    await page.keyboard.press("Enter");
    await page.getByText("a plan that leaves 2 to the enemy, 1 to the friend").waitFor();
    assert.match(await focused(), /^2 possible for the enemy/);
    await lengths(page)
      .getByRole("button", { name: /^16 moves/ })
      .focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press(" ");
    await page.getByText("On the boards: the best plan of 18 moves").waitFor();
  }));

test("both charts follow edits and bounds while the tab is open", () =>
  opened({ document: spread, tab: "Trade-off" }, async (page) => {
    await pairs(page).waitFor();
    const edited = JSON.parse(spread);
    edited.walls.pop();
    const text = JSON.stringify(edited);
    const expected = expectedPairs(text);
    const fresh = expected.find((name) => !expectedPairs(spread).includes(name)) ?? assert.fail("the same pairs");
    await edit(page, text);
    await pairs(page).getByRole("button", { name: fresh, exact: true }).waitFor();
    assert.deepEqual(await names(pairs(page)), expected);
    await openTab(page, "Solve");
    await page.getByLabel("Enemy keeps at least").fill("3");
    await openTab(page, "Trade-off");
    await page
      .getByText(/The shortest plan within the bounds|No plan of at most \d+ moves within the bounds/)
      .waitFor();
    const { outcome } = solve(text, { solver: "exact", pareto: true });
    const outside = (outcome.pareto ?? []).filter(({ adversarial }) => adversarial < 3).length;
    assert.equal(
      await pairs(page)
        .getByRole("button", { name: /outside the bounds/ })
        .count(),
      outside,
    );
  }));

test("what takes long shows progress, is given up, and tells how far it came", () =>
  opened({ document: endless(), stopped: true, tab: "Trade-off" }, async (page) => {
    await page
      .locator(".at-work")
      .getByText(/states looked at/)
      .waitFor();
    await press(page, "Stop");
    const told = page.getByText(/^At least \d+ of 36 pairs can be reached, by the plans that were found until/);
    await page.getByText("There are too many beliefs").waitFor();
    const [, count] = /^At least (\d+) /.exec(await told.innerText()) ?? assert.fail();
    assert(Number(count) > 0);
    assert.equal(await pairs(page).getByRole("button").count(), Number(count));
    assert.match(await told.innerText(), /Whether others can be is not known\.$/);
    await press(page, "Look longer");
    await page
      .locator(".at-work")
      .getByText(/states looked at/)
      .waitFor();
    // An edit takes its place.
    await edit(page, grid());
    await page.getByText("pairs can be reached, by plans of every length").waitFor();
    assert.deepEqual(await names(pairs(page)), expectedPairs(grid()));
  }));

test("a plan can be looked at while the solver goes on", () =>
  opened({ document: endless(), tab: "Trade-off" }, async (page) => {
    await page
      .locator(".at-work")
      .getByText(/states looked at/)
      .waitFor();
    await press(page, "Stop");
    await pairs(page).getByRole("button").first().click();
    await page.getByText("On the boards: a plan that leaves").waitFor();
    assert.equal(await attribute(page, "data-status"), "solving");
    await openTab(page, "Solve");
    await press(page, "Cancel");
    await statusIs(page, "feasible");
  }));

test("a worker that does not obey a stop is replaced, and the page says so", () =>
  opened({ document: laborious(), stopped: true, tab: "Trade-off", before: withDeafWorkers }, async (page) => {
    const work = page.locator(".at-work").getByText(/states looked at/);
    await work.waitFor();
    await press(page, "Stop");
    await page.getByText("The solver did not stop when it was asked to; another took its place.").waitFor();
    await page.getByText("by plans of at most 12 moves").waitFor();
    const { outcome } = solve(laborious(), { solver: "exact", lengths: 12, pareto: true });
    assert.equal(await pairs(page).getByRole("button").count(), outcome.pareto?.length);
  }));

test("time that a worker takes to load is not taken from the time it may look", () =>
  opened({ before: (page) => page.clock.install() }, async (page) => {
    const { asked, release } = await holdCore(page);
    await openTab(page, "Trade-off");
    await asked;
    await page.clock.runFor(20_000);
    release();
    await page.getByText("pairs can be reached, by plans of every length").waitFor();
    assert.equal(await page.getByText("too many beliefs").count(), 0);
  }));

test("a lost worker is told, and another looks again", () =>
  opened({ document: endless(), stopped: true, tab: "Trade-off", before: withKnownWorkers }, async (page) => {
    await page
      .locator(".at-work")
      .getByText(/states looked at/)
      .waitFor();
    await page.evaluate("lastSolver.dispatchEvent(new ErrorEvent('error', { message: 'out of luck' }))");
    await page.getByRole("alert").filter({ hasText: "The solver stopped unexpectedly (out of luck)" }).waitFor();
    assert.equal(await attribute(page, "data-status"), "feasible");
    await press(page, "Try again");
    await page
      .locator(".at-work")
      .getByText(/states looked at/)
      .waitFor();
    await edit(page, grid());
    await page.getByText("pairs can be reached, by plans of every length").waitFor();
  }));

test("a problem that no plan solves has no points", () =>
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
      await openTab(page, "Trade-off");
      await page.getByText("No plan reaches the true goal.").waitFor();
      assert.equal(await page.locator(".point").count(), 0);
    },
  ));

for (const width of [320, 1280]) {
  test(`the charts stay in a screen ${width} pixels wide and have no barrier`, () =>
    opened({ viewport: { width, height: 740 }, hasTouch: true, reducedMotion: "reduce" }, async (page) => {
      await page.getByRole("button", { name: "Raise k" }).tap();
      await openTab(page, "Trade-off");
      await lengths(page).waitFor();
      await pairs(page)
        .getByRole("button", { name: /^3 possible/ })
        .locator(".area")
        .tap();
      await page.getByText("On the boards:").waitFor();
      await page.getByText("The lengths as a table").tap();
      assert((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
      await assertNoBarrier(page, "the charts", { dark: true });
    }));
}
