// The pictures of the further domains, and beliefs shown as sets of states: held against the core's own trace.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { BoxState, RobotState } from "../../www/src/core.js";
import { visit } from "./support/browser.js";
import { explicit } from "./support/documents.js";
import { drawn, statusIs } from "./support/playground.js";
import { board, drop, goTo, open, switches } from "./support/views.js";

const roles = ["adversarial", "cooperative"] as const;

const cells = (page: Page, name: string, attribute: string) =>
  board(page, name)
    .locator(`[${attribute}]`)
    .evaluateAll((marks, key) => marks.map((mark) => mark.getAttribute(key) ?? ""), attribute);
const sorted = (values: Iterable<string>) => [...new Set(values)].sort();

test("box pushing: at every step the boards hold the robot's cells and the box's that the core believes", () =>
  open("box-pushing", async (page, trace) => {
    for (const [index, step] of trace.steps.entries()) {
      await goTo(page, index);
      const shown = await drawn(page);
      for (const role of roles) {
        const belief = step.beliefs[role] as BoxState[];
        assert.deepEqual(
          shown.believed[role].sort(),
          sorted(belief.map(({ robot }) => String(robot))),
          `step ${index}`,
        );
        assert.deepEqual(sorted(await cells(page, role, "data-box")), sorted(belief.map(({ box }) => String(box))));
      }
      const { robot, facing, box } = step.state as BoxState;
      assert.deepEqual(await cells(page, "actor", "data-box"), [String(box)]);
      const label = await board(page, "actor").getAttribute("aria-label");
      assert.equal(
        label,
        `After ${index} ${index === 1 ? "action" : "actions"}: the robot in column ${robot[0]}, row ${robot[1]} looks ${facing}; the box is in column ${box[0]}, row ${box[1]}.`,
      );
      for (const goal of shown.goals) {
        for (const role of roles) {
          assert.equal(
            goal[role],
            step.goals[role].includes(goal.name) ? "alive" : "dead",
            `${goal.name}, step ${index}`,
          );
        }
        assert.equal(goal.isTrue, goal.name === "G1");
      }
    }
    // All candidate goals are on each board.
    for (const name of ["actor", ...roles]) assert.equal(await board(page, name).locator("[data-goal]").count(), 3);
  }));

test("the recycling robot: can, battery and robot are where the core says, on all boards", () =>
  open("recycling-robot", async (page, trace) => {
    const carried = trace.steps.findIndex(({ state }) => (state as RobotState).can === "held");
    assert(carried > 0);
    for (const index of [0, carried, trace.steps.length - 1]) {
      const step = trace.steps[index] ?? assert.fail();
      await goTo(page, index);
      const shown = await drawn(page);
      for (const role of roles) {
        const belief = step.beliefs[role] as RobotState[];
        assert.deepEqual(shown.believed[role].sort(), sorted(belief.map(({ robot }) => String(robot))));
        const lying = belief.flatMap(({ can }) => (can === "held" ? [] : [String(can)]));
        assert.deepEqual(sorted(await cells(page, role, "data-can")), sorted(lying));
        const levels = sorted(belief.map(({ battery }) => String(battery)));
        const title = await board(page, role).locator(".battery title").textContent();
        const [low, high] = [levels[0], levels.at(-1)];
        assert.equal(title, `battery level ${low === high ? low : `${low}–${high}`} of 4`);
      }
      const { can, battery } = step.state as RobotState;
      assert.deepEqual(await cells(page, "actor", "data-can"), can === "held" ? [] : [String(can)]);
      const label = (await board(page, "actor").getAttribute("aria-label")) ?? "";
      assert(label.endsWith(`battery level ${battery}.`), label);
      assert.equal(label.includes("it carries the can"), can === "held");
    }
  }));

test("blocks: one state is its towers, some are a picture each, many are counted", () =>
  open("blocks", async (page, trace) => {
    await goTo(page, 0);
    for (const role of roles) {
      assert.equal(await board(page, role).locator("[data-believed]").count(), 1);
    }
    assert.deepEqual(await blocksOf(page, "actor"), ["d", "b", "a", "e", "c"].sort());
    const few = trace.steps.findIndex(
      ({ beliefs }) => beliefs.cooperative.length > 1 && beliefs.cooperative.length < 7,
    );
    assert(few > 0);
    await goTo(page, few);
    const states = trace.steps[few]?.beliefs.cooperative ?? [];
    assert.equal(await board(page, "cooperative").locator("[data-believed]").count(), states.length);
    await goTo(page, trace.steps.length - 1);
    const end = trace.steps.at(-1) ?? assert.fail();
    const belief = end.beliefs.adversarial as string[][];
    const text = (await board(page, "adversarial").locator(".summary").innerText()).replaceAll(/\s+/g, " ");
    assert(text.startsWith(`${belief.length} states;`), text);
    const lines = await board(page, "adversarial").locator(".summary > ul > li").allInnerTexts();
    assert(lines.length > 0);
    for (const line of lines) {
      const [, count, above, below] = /^in (\d+) of them (\w+) is on (\w+)$/.exec(line) ?? assert.fail(line);
      assert.equal(Number(count), belief.filter((state) => state.includes(`(on ${above} ${below})`)).length, line);
    }
    assert(text.includes("G1 holds in 1"), text);
    // The candidate goals are small towers with their marks.
    assert.equal(await board(page, "actor").locator("li[data-goal] svg.towers").count(), 5);
    assert.equal(await board(page, "actor").locator("li[data-goal][data-true-goal]").count(), 1);
  }));

const blocksOf = async (page: Page, name: string) =>
  (await board(page, name).locator(".state .block title").allTextContents()).sort();

test("a large belief is told in numbers, and its single states can be leafed through", () =>
  open("blocks-unseen", async (page, trace) => {
    await goTo(page, 0);
    const enemy = board(page, "adversarial");
    await enemy.getByText("501", { exact: true }).first().waitFor();
    const belief = trace.steps[0]?.beliefs.adversarial as string[][];
    await enemy.getByText("Look at single states").click();
    await enemy.getByText("States 1 to 6 of 501").waitFor();
    assert.equal(await enemy.locator("[data-believed]").count(), 6);
    await enemy.getByRole("button", { name: "Next: states of the enemy" }).click();
    await enemy.getByText("States 7 to 12 of 501").waitFor();
    await enemy.getByText("the first 100 can be looked at").waitFor();
    await enemy.getByText("More of what may be so").click();
    const all = await enemy.locator(".summary li").allInnerTexts();
    for (const line of all) {
      const [, count = "", words = ""] = /^in ([\d,]+) of them (.*)$/.exec(line) ?? assert.fail(line);
      assert.equal(Number(count), belief.filter((state) => state.some((fact) => says(fact) === words)).length, line);
    }
    assert(all.length > 20);
    // The page's own words agree: the steps table and the live region count states, not pictures.
    await page.locator('[aria-live="polite"]', { hasText: "501 states left" }).waitFor({ state: "attached" });
  }));

/** The words that a person reads, made here from the fact. */
function says(fact: string): string {
  const [predicate, first, second] = fact.replace(/[()]/g, "").split(" ");
  if (predicate === "on") return `${first} is on ${second}`;
  if (predicate === "ontable") return `${first} is on the table`;
  if (predicate === "clear") return `nothing is on ${first}`;
  return predicate === "holding" ? `the hand holds ${first}` : "the hand is empty";
}

for (const name of ["logistics", "driverlog"]) {
  test(`${name}: everything is where the core says, at every step`, () =>
    open(name, async (page, trace) => {
      for (const index of [0, 3, 6, trace.steps.length - 1]) {
        await goTo(page, index);
        const facts = (trace.steps[index] ?? assert.fail()).state as string[];
        const seen = await board(page, "actor").evaluate((element) => {
          return [...element.querySelectorAll(".thing-box")].map((thing) => {
            const outer = thing.parentElement?.closest(".thing-box, .place-card");
            const relation = outer?.classList.contains("place-card")
              ? "at"
              : thing.classList.contains("drives")
                ? "driving"
                : "in";
            const names = [thing, outer].map((part) => part?.querySelector(":scope > .name")?.textContent ?? "");
            return `(${relation} ${names.join(" ")})`;
          });
        });
        assert.deepEqual(seen.sort(), facts.filter((fact) => /^\((at|in|driving) /.test(fact)).sort(), `step ${index}`);
      }
      for (const role of roles) {
        const states = trace.steps.at(-1)?.beliefs[role].length ?? 0;
        const label = await board(page, role).getAttribute("aria-label");
        assert(label?.endsWith(`holds ${states} ${states === 1 ? "state" : "states"} possible.`), `${label}`);
      }
      // A goal without a place says what it asks for.
      await page.locator(".goals tr[data-goal=G1] .asked", { hasText: "p1 is at" }).waitFor();
    }));
}

test("driverlog: what may be so is drawn with the number of states", () =>
  open("driverlog", async (page, trace) => {
    const belief = trace.steps.at(-1)?.beliefs.adversarial as string[][];
    const enemy = board(page, "adversarial");
    const perhaps = await enemy.locator(".thing-box.perhaps").evaluateAll((things) =>
      things.map((thing) => ({
        name: thing.querySelector(":scope > .name")?.textContent,
        at: thing.parentElement?.closest(".place-card")?.querySelector(":scope > .name")?.textContent,
        nested: thing.parentElement?.closest(".thing-box") !== null,
        states: thing.querySelector(":scope > .in")?.textContent,
      })),
    );
    assert(perhaps.length > 5);
    for (const { name, at, states } of perhaps.filter(({ nested }) => !nested)) {
      const count = belief.filter((state) => state.includes(`(at ${name} ${at})`)).length;
      assert.equal(states, `${count}/${belief.length}`, `${name} at ${at}`);
    }
  }));

test("a problem of a domain of one's own shows its facts by predicate", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await drop(page, switches());
    await board(page, "actor").locator("dt", { hasText: "up" }).waitFor();
    await board(page, "cooperative").locator("dt").first().waitFor();
    await drop(page, explicit);
    await board(page, "actor").locator(".state-name", { hasText: "s1" }).waitFor();
    assert.equal(await board(page, "adversarial").locator("[data-believed]").count(), 2);
  }));
