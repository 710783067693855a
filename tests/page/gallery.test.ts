// The gallery: every problem shows what its sentence says, and the page leads to each of them.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { sameProblem } from "../../www/src/problem/same.js";
import { written } from "../../www/src/problem/text.js";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { replay, solve } from "./support/core.js";
import { best, documentOf, entries, planned } from "./support/gallery.js";
import { dragMouse } from "./support/hands.js";
import { attribute, press, statusIs, stepIs } from "./support/playground.js";

const near = (value: number | null | undefined, wanted: number) =>
  assert(value !== null && value !== undefined && Math.abs(value - wanted) < 1e-9, `${value} is not ${wanted}`);

/** What each sentence says, in numbers. */
const claims: Record<string, () => void> = {
  "eight-by-eight": () => {
    assert.deepEqual(planned("eight-by-eight", "Straight there"), { moves: 14, difference: 2 / 3, valid: true });
    assert.deepEqual(planned("eight-by-eight", "With a detour"), { moves: 16, difference: 1, valid: true });
    // No shorter plan does as well.
    near(solve(documentOf("eight-by-eight"), { solver: "exact", horizon: 14 }).outcome.goal_difference, 2 / 3);
  },
  "head-fake": () => {
    assert.deepEqual(planned("head-fake", "Straight there"), { moves: 6, difference: 0, valid: true });
    const { trace } = solve(documentOf("head-fake"), { solver: "exact" });
    assert.equal(trace.goal_difference, 1);
    const seen = trace.steps.findIndex(({ symbols }) => symbols.adversarial === "seen at 1,3");
    assert(seen > 0, "the agent shows itself at the door");
    assert.equal(trace.steps[seen]?.beliefs.adversarial.length, 1);
  },
  delivery: () => {
    assert.deepEqual(planned("delivery", "Both from A"), { moves: 3, difference: 1, valid: true });
    near(planned("delivery", "One from each").difference, 0.4);
  },
  "blind-enemy": () => {
    assert.deepEqual(planned("blind-enemy", "Straight there"), { moves: 3, difference: 0, valid: true });
    assert.deepEqual(planned("blind-enemy", "Dawdling"), { moves: 9, difference: 1, valid: true });
    for (let length = 3; length < 9; length += 1) {
      const { outcome } = solve(documentOf("blind-enemy"), { solver: "exact", horizon: length });
      assert((outcome.goal_difference ?? 0) < 1, `${length} moves`);
    }
  },
  "blind-friend": () => near(best("blind-friend"), 0),
  "camera-zone": () => {
    assert.deepEqual(planned("camera-zone", "Through"), { moves: 8, difference: 0, valid: true });
    assert.deepEqual(planned("camera-zone", "Around"), { moves: 12, difference: 1, valid: true });
    const { trace } = solve(documentOf("camera-zone"), { solver: "exact" });
    assert(trace.steps.every(({ symbols }) => !symbols.adversarial?.startsWith("seen")));
  },
  corridor: () => {
    assert.deepEqual(planned("corridor", "Straight there"), { moves: 3, difference: 1 / 3, valid: true });
    const { trace } = solve(documentOf("corridor"), { solver: "exact" });
    const past = planned("corridor", "Past and back");
    assert.deepEqual(past, { moves: 5, difference: best("corridor"), valid: true });
    assert.equal(trace.steps.at(-1)?.goals.adversarial.length, 4);
  },
  "three-rooms": () => {
    assert.deepEqual(planned("three-rooms", "Along the wall"), { moves: 6, difference: 0.5, valid: true });
    assert.deepEqual(planned("three-rooms", "As in every room"), { moves: 6, difference: 1, valid: true });
    // In how many rooms the enemy believes at the end.
    const rooms = (plan: readonly string[] | undefined) =>
      replay(documentOf("three-rooms"), [...(plan ?? [])]).steps.at(-1)?.beliefs.adversarial.length;
    const wall = entries.find(({ name }) => name === "three-rooms")?.plans?.[0];
    assert.equal(rooms(wall?.plan), 2);
    assert.equal(rooms(solve(documentOf("three-rooms"), { solver: "exact" }).outcome.plan ?? []), 3);
  },
  parity: () => near(best("parity"), 0.5),
  "stay-and-wait": () => {
    near(best("stay-and-wait"), 1);
    assert.deepEqual(planned("stay-and-wait", "Wait, then go"), { moves: 5, difference: 1, valid: true });
    assert(planned("stay-and-wait", "Straight there").difference < 1);
    // The same grid as the one before.
    const [moving, waiting] = ["parity", "stay-and-wait"].map((name) => JSON.parse(documentOf(name)));
    assert.deepEqual([moving.walls, moving.goals, moving.start], [waiting.walls, waiting.goals, waiting.start]);
  },
  city: () => {
    assert.deepEqual(planned("city", "Straight there"), { moves: 32, difference: 0, valid: true });
    assert.deepEqual(planned("city", "Other streets"), { moves: 44, difference: 1, valid: true });
  },
  "goal-in-sight": () => near(best("goal-in-sight"), 0),
  "not-seen": () => near(best("not-seen"), 0),
  "delivery-larger": () => {
    const [a, b, each] = ["All from A", "Two from B", "One from each"].map((title) =>
      planned("delivery-larger", title),
    );
    near(a?.difference, 1);
    near(b?.difference, (56 - 3) / 55);
    near(each?.difference, (56 - 18) / 55);
  },
  "box-pushing": () => {
    assert.deepEqual(planned("box-pushing", "Straight up"), { moves: 4, difference: 0, valid: true });
    assert.deepEqual(planned("box-pushing", "A roundabout way"), { moves: 11, difference: 1, valid: true });
    const { trace } = solve(documentOf("box-pushing"), { solver: "exact" });
    assert.equal(trace.steps.at(-1)?.goals.adversarial.length, 3);
  },
  "recycling-robot": () => {
    assert.deepEqual(planned("recycling-robot", "Straight there"), { moves: 9, difference: 0, valid: true });
    assert.deepEqual(planned("recycling-robot", "Charge and pause"), { moves: 14, difference: 1, valid: true });
    const actions = solve(documentOf("recycling-robot"), { solver: "exact" }).outcome.plan ?? [];
    assert(actions.includes("stay") && actions.filter((action) => action === "charge").length === 2);
  },
  blocks: () => {
    assert.deepEqual(planned("blocks", "A detour"), { moves: 16, difference: 0, valid: true });
    assert.deepEqual(planned("blocks", "The shortest"), { moves: 14, difference: 1, valid: true });
    for (const length of [12, 13]) {
      assert.equal(solve(documentOf("blocks"), { solver: "exact", horizon: length }).outcome.status, "infeasible");
    }
  },
  "blocks-unseen": () => {
    const { trace } = solve(documentOf("blocks-unseen"), { solver: "exact" });
    assert.equal(trace.steps[0]?.beliefs.adversarial.length, 501);
    assert.equal(trace.steps.length, 13);
    assert.equal(trace.steps.at(-1)?.goals.adversarial.length, 5);
    assert.equal(trace.goal_difference, 1);
  },
  logistics: () => {
    assert.deepEqual(planned("logistics", "Straight there"), { moves: 8, difference: 0.25, valid: true });
    assert.deepEqual(planned("logistics", "For nothing"), { moves: 11, difference: 0.5, valid: true });
    const { outcome } = solve(documentOf("logistics"), { solver: "exact" });
    assert.equal(outcome.goals?.adversarial.length, 3);
    assert.equal(outcome.goal_difference, 0.5);
  },
  driverlog: () => {
    assert.deepEqual(planned("driverlog", "Unload at once"), { moves: 11, difference: 0.5, valid: true });
    assert.deepEqual(planned("driverlog", "Unload last"), { moves: 11, difference: 1, valid: true });
    const { outcome } = solve(documentOf("driverlog"), { solver: "exact" });
    assert.equal(outcome.goals?.adversarial.length, 5);
    // The same actions in another order.
    const [first, last] = entries.find(({ name }) => name === "driverlog")?.plans ?? [];
    assert.deepEqual([...(last?.plan ?? [])].sort(), [...(first?.plan ?? [])].sort());
  },
};

test("the gallery has the documents of its folder, the paper's first", () => {
  const files = readdirSync(new URL("../../www/problems/", import.meta.url));
  assert.deepEqual(files.sort(), entries.map(({ name }) => `${name}.json`).sort());
  assert.deepEqual(Object.keys(claims).sort(), entries.map(({ name }) => name).sort());
  assert.equal(entries[0]?.name, "eight-by-eight");
  assert(entries.length >= 10);
  for (const { title, about } of entries) {
    // One line on a wide screen.
    assert(about.length <= 140 && title.length <= 30, `${title}: ${about.length}`);
  }
});

for (const { name, title } of entries) {
  test(`${title}: it is as its sentence says`, () => {
    const text = documentOf(name);
    const { outcome } = solve(text, { solver: "exact" });
    assert.equal(outcome.status, "optimal");
    assert.equal(written(JSON.parse(text)), text, "written as the page writes documents");
    claims[name]?.();
  });
}

test("two texts of one problem are the same problem, another problem is not", () => {
  const one = JSON.parse(documentOf("eight-by-eight"));
  const turned = { ...one, walls: [...one.walls].reverse(), observers: { ...one.observers } };
  assert(sameProblem(one, turned));
  assert(sameProblem({ ...one, stay: undefined }, one));
  assert(!sameProblem({ ...one, walls: one.walls.slice(1) }, one));
  assert(!sameProblem({ ...one, true_goal: "G2" }, one));
  assert(!sameProblem({ ...one, goals: [...one.goals].reverse() }, one));
});

const bar = (page: Page) => page.getByRole("region", { name: "Problem", exact: true });
const showing = (page: Page, title: string) => bar(page).locator(".title", { hasText: title }).waitFor();
const menu = (page: Page) => page.getByRole("dialog", { name: "Problems" });

for (const viewport of [
  { width: 1280, height: 800 },
  { width: 390, height: 844 },
]) {
  test(`every problem is opened from the gallery and solved, ${viewport.width} wide`, () =>
    visit(
      async ({ page }) => {
        await statusIs(page, "optimal");
        for (const { name, title, about } of entries) {
          await page.getByTitle("All problems").click();
          await menu(page).getByRole("button", { name: title }).click();
          await menu(page).waitFor({ state: "hidden" });
          await showing(page, title);
          await statusIs(page, "optimal");
          assert.equal(await bar(page).locator(".about").textContent(), about);
          assert.equal(await attribute(page, "data-gd"), String(best(name)));
          const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
          assert(overflow <= 0, `${title}: ${overflow} pixels too wide`);
        }
      },
      { viewport },
    ));
}

test("both of the paper's plans are one click apart", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.getByTitle("All problems").click();
    await menu(page).getByRole("button", { name: "The paper’s delivery" }).click();
    await page.waitForSelector('mo-copp-playground[data-gd="1"][data-step="3"]');
    await press(page, "One from each");
    await page.waitForSelector('mo-copp-playground[data-gd="0.4"]');
    await page.locator('button[aria-pressed="true"]', { hasText: "One from each" }).waitFor();
    // It is still the paper's delivery.
    await showing(page, "The paper’s delivery");
    assert.equal(await page.locator('tr[data-cooperative="alive"]').count(), 4);
    assert.equal(await page.locator('tr[data-adversarial="alive"]').count(), 6);
    await press(page, "Both from A");
    await page.waitForSelector('mo-copp-playground[data-gd="1"]');
    assert.equal(await page.locator('tr[data-cooperative="alive"]').count(), 1);
  }));

test("a named plan is shown, and the best again", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await press(page, "Straight there");
    await stepIs(page, 14);
    assert.equal(await attribute(page, "data-gd"), String(2 / 3));
    await page.locator('button[aria-pressed="true"]', { hasText: "Straight there" }).waitFor();
    await press(page, "With a detour");
    await stepIs(page, 16);
    assert.equal(await attribute(page, "data-gd"), "1");
    await page.locator('button[aria-pressed="true"]', { hasText: "With a detour" }).waitFor();
  }));

test("the arrows go round, and an edited problem is no longer called by its name", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await press(page, "Problem before");
    await showing(page, entries.at(-1)?.title ?? "");
    await press(page, "Next problem");
    await showing(page, "The paper’s gridworld");
    await statusIs(page, "optimal");
    await dragMouse(page, "actor", [
      [7, 4],
      [7, 5],
    ]);
    await showing(page, "An edited problem");
    await page.keyboard.press("Control+z");
    await showing(page, "The paper’s gridworld");
  }));

test("the menu works by keyboard alone, and gives the focus back", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const opener = page.getByTitle("All problems");
    await opener.focus();
    await page.keyboard.press("Enter");
    await menu(page).waitFor();
    // Close, then the cards in their order.
    await page.keyboard.press("Tab");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    await showing(page, entries[1]?.title ?? "");
    await menu(page).waitFor({ state: "hidden" });
    await opener.focus();
    await page.keyboard.press("Enter");
    await menu(page).waitFor();
    await page.keyboard.press("Escape");
    await menu(page).waitFor({ state: "hidden" });
    assert.equal(await opener.evaluate((element) => element === document.activeElement), true);
  }));

test("axe finds no barrier in the gallery, light and dark", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.getByTitle("All problems").click();
    await page.locator(".problem svg").nth(13).waitFor();
    await assertNoBarrier(page, "the gallery", { dark: true });
  }));

test("the boards, the goal difference and the stepper are on one screen with the problem", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    for (const part of [bar(page), page.locator(".stage"), page.locator(".difference"), page.locator(".stepper")]) {
      const box = (await part.boundingBox()) ?? assert.fail();
      assert(box.y >= 0 && box.y + box.height <= 800, `${box.y} to ${box.y + box.height}`);
    }
    const { y, height } = (await page.locator(".stage").boundingBox()) ?? assert.fail();
    const stepper = (await page.locator(".stepper").boundingBox()) ?? assert.fail();
    assert(y + height <= stepper.y, "the stepper covers no board");
  }));
