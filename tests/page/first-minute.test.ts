// The first minute: the page opens at the first step with one invitation, all that it takes is in sight, and a tour is
// offered once.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNoBarrier } from "./support/barriers.js";
import { type Options, visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { attribute, openTab, press, slider, statusIs, stepIs, useDocument } from "./support/playground.js";
import { address } from "./support/site.js";

const invitation = (page: Page) => page.getByRole("button", { name: /^Watch the \d+ moves?$/ });
const offer = (page: Page) => page.getByRole("button", { name: "Take the tour" });
const card = (page: Page) => page.getByRole("dialog", { name: /^Tour, stop/ });

const opened = (use: (page: Page) => Promise<void>, options: Options = {}) =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await use(page);
    },
    { reducedMotion: "reduce", ...options },
  );

test("it opens at the first step, and one button plays from there", () =>
  opened(async (page) => {
    assert.equal(await attribute(page, "data-step"), "0");
    assert.equal(await attribute(page, "data-gd"), "1");
    assert.equal(await invitation(page).count(), 1);
    // Nothing of the plan's end is claimed of its start.
    assert.equal(await page.locator(".difference .value").getByText("Goal difference").count(), 0);
    await invitation(page).click();
    await page.waitForFunction(() => document.activeElement?.matches(".stepper .main") ?? false);
    await stepIs(page, 1);
    assert.equal(await invitation(page).count(), 0);
    await press(page, "Pause");
    await press(page, "First step");
    await stepIs(page, 0);
    assert.equal(await invitation(page).count(), 0);
    await press(page, "Last step");
    await page.getByText("Goal difference 1", { exact: false }).first().waitFor();
  }));

test("what an edit makes is shown at its end, until somebody goes to a step", () =>
  opened(async (page) => {
    await page.getByLabel("Plan length").fill("14");
    await stepIs(page, 14);
    await slider(page).fill("3");
    await page.getByLabel("Plan length").fill("16");
    await page.waitForFunction(() => document.querySelector(".stepper .count")?.textContent?.includes("16"));
    assert.equal(await attribute(page, "data-step"), "3");
  }));

test("a frame without the bar of the steps shows the end", () =>
  opened(async (page) => {
    await page.goto(`${address}?problem=corridor&hide=stepper`);
    await statusIs(page, "optimal");
    await stepIs(page, 5);
  }));

for (const [width, height] of [
  [1280, 800],
  [390, 844],
] as const) {
  test(`board, goals, step and play are in sight without scrolling, ${width} by ${height}`, () =>
    opened(
      async (page) => {
        const hidden = await page.evaluate(() => {
          const bar = document.querySelector(".stepper")?.getBoundingClientRect();
          const parts = [
            ...document.querySelectorAll(
              'svg[data-board="actor"], svg[data-board="actor"] [data-goal], .watch, .difference .parts',
            ),
            ...(innerWidth > 800 ? document.querySelectorAll("svg[data-board], .survivors li") : []),
          ];
          return parts
            .filter((part) => {
              const { top, bottom } = part.getBoundingClientRect();
              return bar === undefined || top < 0 || bottom > bar.top + 1;
            })
            .map((part) => part.getAttribute("data-goal") ?? part.className.toString());
        });
        assert.deepEqual(hidden, []);
        for (const name of ["Play", "Forward one step"]) {
          const box = await page.getByRole("button", { name, exact: true }).boundingBox();
          assert(box !== null && box.y >= 0 && box.y + box.height <= height, name);
        }
        assert.equal(await page.evaluate(() => scrollY), 0);
      },
      { viewport: { width, height } },
    ));
}

test("the tour has five stops, goes by keyboard, and is not offered again", () =>
  opened(async (page) => {
    await offer(page).focus();
    await page.keyboard.press("Enter");
    const stops: string[] = [];
    for (let stop = 1; stop <= 5; stop += 1) {
      await page.locator(`.tour[data-stop="${stop}"]`).waitFor();
      await page.waitForFunction(() => document.activeElement?.matches(".tour") ?? false);
      stops.push((await card(page).getAttribute("aria-label")) ?? "");
      assert.equal(await page.locator("[data-tour]").count(), 1);
      if (stop === 2) await assertNoBarrier(page, "the tour");
      await page.keyboard.press("ArrowRight");
    }
    assert.equal(new Set(stops).size, 5);
    assert.match(stops[4] ?? "", /^Tour, stop 5 of 5: Step by step$/);
    // The keys of the tour are its own.
    assert.equal(await attribute(page, "data-step"), "0");
    await card(page).getByRole("button", { name: "Done" }).click();
    assert.equal(await card(page).count(), 0);
    assert.equal(await page.locator("[data-tour]").count(), 0);
    await page.waitForFunction(() => document.activeElement?.matches(".watch") ?? false);
    await page.goto(address);
    await statusIs(page, "optimal");
    await invitation(page).waitFor();
    assert.equal(await offer(page).count(), 0);
  }));

test("the tour can be left at once, also on a phone", () =>
  opened(
    async (page) => {
      await offer(page).click();
      await card(page).waitFor();
      const box = await card(page).boundingBox();
      const bar = await page.locator(".stepper").boundingBox();
      assert(box !== null && bar !== null && box.x >= 0 && box.x + box.width <= 390 && box.y + box.height <= bar.y + 1);
      await page.keyboard.press("Escape");
      await card(page).waitFor({ state: "detached" });
      assert.equal(await offer(page).count(), 0);
    },
    { viewport: { width: 390, height: 844 } },
  ));

test("where nothing may be kept, the tour is not offered again in the session", () =>
  opened(
    async (page) => {
      await offer(page).click();
      await page.getByRole("button", { name: "Skip the tour" }).click();
      await page.reload();
      await statusIs(page, "optimal");
      await page.locator(".difference").waitFor();
      assert.equal(await offer(page).count(), 0);
    },
    {
      before: (page) =>
        page.addInitScript(() => {
          for (const name of ["localStorage", "sessionStorage"]) {
            Object.defineProperty(window, name, {
              get() {
                throw new DOMException("forbidden", "SecurityError");
              },
            });
          }
        }),
    },
  ));

test("nothing is called ruled out that may still come, and mid-plan no goal difference is claimed", () =>
  opened(async (page) => {
    assert.equal(await page.locator(".stage .goal.dead, .survivors .dead, table.goals .dead").count(), 0);
    assert.equal(await page.locator(".survivors .unseen", { hasText: "not now" }).count(), 8);
    // The attributes keep their values.
    assert.equal(await page.locator('.survivors [data-adversarial="dead"]').count(), 8);
    const last = Number(await slider(page).getAttribute("max"));
    await page.locator(".difference .parts", { hasText: "0 possible for the enemy, 0 for the friend" }).waitFor();
    for (let step = 1; step < last; step += 1) {
      await slider(page).fill(String(step));
      await stepIs(page, step);
      assert.equal(await page.locator(".difference .value b").count(), 0, `step ${step}`);
      await page.locator(".difference .parts", { hasText: "of 4 goals" }).waitFor();
    }
    await slider(page).fill(String(last));
    await page.locator(".difference .value b", { hasText: "1" }).waitFor();
    assert.equal(await page.locator(".panel.cooperative .survivors .dead").count(), 3);
    assert.equal(await page.locator(".panel.cooperative .survivors .unseen", { hasText: "ruled out" }).count(), 3);
  }));

const oneWay = grid({
  width: 3,
  height: 2,
  walls: [],
  start: [1, 0],
  goals: [
    { name: "L", cell: [0, 0] },
    { name: "R", cell: [2, 0] },
  ],
  true_goal: "R",
});

test("why a goal is not possible is said, and drawn on the board", () =>
  opened(async (page) => {
    await useDocument(page, oneWay);
    await page.locator('.survivors [data-goal="L"]').first().waitFor();
    await statusIs(page, "optimal");
    await openTab(page, "Solve");
    await page.getByLabel("Plan length").fill("1");
    await stepIs(page, 1);
    await page.getByRole("button", { name: "L", exact: true }).click();
    // The friend was told north-east for the move east; west would have been south-west.
    const because = page.locator(".panel.cooperative .because");
    await because
      .getByText(
        "before step 1 it was one action away (west) from 1 place: south-west. The friend was told north-east.",
      )
      .waitFor();
    const marks = page.locator('svg[data-board="cooperative"] .reason');
    assert.equal(await marks.getAttribute("data-reason"), "1");
    assert.equal(await marks.locator(".last").count(), 1);
    assert.equal(await marks.locator(".missed").count(), 1);
    // For the enemy, who is told horizontal for both, it is possible.
    assert.equal(await page.locator(".panel.adversarial .because").count(), 0);
    assert.equal(await page.locator('svg[data-board="adversarial"] .reason').count(), 0);
    await assertNoBarrier(page, "a reason");
    await press(page, "Back one step");
    await stepIs(page, 0);
    // Nothing has ended it: it is as far away as the nearest of the places that are believed.
    await because.getByText("from the nearest place believed now it is 1 action away.").waitFor();
    assert.equal(await marks.getAttribute("data-reason"), "now");
    assert.equal(await marks.locator(".last").count(), 1);
  }));

test("a goal that is chosen on a board is asked about where one is, and chosen again, where that began", () =>
  opened(async (page) => {
    const chip = (role: string, goal: string) => page.locator(`.panel.${role} .survivors [data-goal="${goal}"]`);
    const because = (role: string) => page.locator(`.panel.${role} .because`);
    await page.locator(".difference .final", { hasText: "Goal difference at the end: 1." }).waitFor();
    await slider(page).fill("3");
    await stepIs(page, 3);
    await chip("cooperative", "G4").click();
    await because("cooperative")
      .getByText(/not possible now: from the nearest place believed now it is \d+ actions? away\./)
      .waitFor();
    assert.equal(await attribute(page, "data-step"), "3");
    await chip("cooperative", "G4").click();
    await stepIs(page, 11);
    const last = Number(await slider(page).getAttribute("max"));
    await slider(page).fill(String(last));
    await stepIs(page, last);
    await chip("cooperative", "G2").click();
    await because("cooperative").getByText("ruled out: before step").waitFor();
    await chip("cooperative", "G3").click();
    await because("cooperative")
      .getByText(/ruled out: from the nearest place believed now it is \d+ actions? away, and the plan ends here\./)
      .waitFor();
    assert.equal(await attribute(page, "data-step"), String(last));
    // No chip offers what it does not do.
    for (const role of ["adversarial", "cooperative"]) {
      const chips = await page.locator(`.panel.${role} .survivors li`).evaluateAll((all) =>
        all.map((one) => ({
          possible: one.getAttribute(`data-${one.closest(".adversarial") ? "adversarial" : "cooperative"}`) === "alive",
          title: (one as HTMLElement).title,
        })),
      );
      assert.equal(chips.length, 4);
      for (const { possible, title } of chips)
        assert.match(title, possible ? /: possible, and at the end as well$/ : /: show why it is not possible$/);
    }
  }));
