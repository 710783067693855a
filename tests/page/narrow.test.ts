// What has to be read whole on every screen: texts in their boxes, formulas, signs, and names that go on and on.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Locator, Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { delivery, figure1, grid } from "./support/documents.js";
import { openTab, press, slider, statusIs, stepIs, useDocument } from "./support/playground.js";
import { address } from "./support/site.js";

const widths = [320, 390, 820, 1280] as const;
const at = (width: number) => ({ viewport: { width, height: 800 }, reducedMotion: "reduce" }) as const;
const phone = at(320);

const overflow = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

/** Whether what an element holds is cut off. */
const isCut = (element: Locator) =>
  element.evaluate((part) => part.scrollWidth > part.clientWidth + 1 || part.scrollHeight > part.clientHeight + 1);

const named = JSON.stringify({
  ...JSON.parse(figure1),
  factories: [
    { name: "Amsterdam-Noord", packages: ["W10", "medicine"] },
    { name: "B", packages: ["b1", "b2"] },
  ],
  true_goal: "W10+medicine",
  observers: {
    adversarial: { sensor: { load: "package", deliver: "delivery" } },
    cooperative: { sensor: { load: { "Amsterdam-Noord": "barcode A", B: "barcode B" }, deliver: "delivery" } },
  },
});

interface Room {
  text: string | null;
  left: number;
  right: number;
}

/** The room that texts have on either side: in packages, in the delivery area, and beside the roofs; and letters' sizes. */
async function measured(page: Page): Promise<[packages: Room[], areas: Room[], factories: Room[], sizes: number[]]> {
  const pairs = [
    [".package text", ".box"],
    [".area + .place", ".area"],
    [".factory .place", ".walls"],
  ] as const;
  const rooms = await page.evaluate(
    (all) =>
      all.map(([texts, box]) =>
        [...document.querySelectorAll<SVGGraphicsElement>(`svg.delivery ${texts}`)].map((text) => {
          const inner = text.getBBox();
          const outer = text.parentElement?.querySelector<SVGGraphicsElement>(box)?.getBBox() ?? inner;
          const right = outer.x + outer.width - inner.x - inner.width;
          return { text: text.textContent, left: inner.x - outer.x, right };
        }),
      ),
    pairs,
  );
  const sizes = await page
    .locator("svg.delivery .factory .package text:not(.long, .doubt)")
    .evaluateAll((texts) =>
      (texts as SVGGraphicsElement[]).map(
        (text) => Number.parseFloat(getComputedStyle(text).fontSize) * (text.getScreenCTM()?.a ?? 0),
      ),
    );
  const [packages = [], areas = [], factories = []] = rooms;
  return [packages, areas, factories, sizes];
}

for (const width of widths) {
  for (const [title, problem] of [
    ["the paper's", figure1],
    ["long names", named],
    ["five at once", delivery([4, 3], 5)],
  ] as const) {
    test(`no text of a delivery touches its box, ${title}, ${width} pixels wide`, () =>
      visit(async ({ page }) => {
        await statusIs(page, "optimal");
        await useDocument(page, problem);
        await page.locator("svg.delivery").first().waitFor();
        await statusIs(page, "optimal");
        const last = Number(await slider(page).getAttribute("max"));
        for (const step of [0, 1, last]) {
          await slider(page).fill(String(step));
          await stepIs(page, step);
          const [packages, areas, factories, sizes] = await measured(page);
          assert(packages.length >= 4 && areas.length === 3 && factories.length >= 3);
          const touching = [
            ...packages.filter(({ left, right }) => left < 0.04 || right < 0.04),
            ...areas.filter(({ left, right }) => left < 0.2 || right < 0.2),
            // The roof's teeth are 1.8 wide.
            ...factories.filter(({ left, right }) => left < 1.85 || right < 0.1),
          ];
          assert.deepEqual(touching, []);
          assert(Math.min(...sizes) >= 8, `letters of ${Math.min(...sizes)} pixels`);
        }
        assert((await overflow(page)) <= 0);
      }, at(width)));
  }
}

test("the formula of the goal difference breaks nowhere inside of its brackets", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const goals = Array.from({ length: 11 }, (_, index) => ({ name: `goal ${index}`, cell: [3, index % 3] }));
    for (const problem of [null, grid({ goals, true_goal: "goal 0" })]) {
      if (problem !== null) await useDocument(page, problem);
      await slider(page).fill((await slider(page).getAttribute("max")) ?? assert.fail());
      await page.getByText(problem === null ? "÷ (4 − 1)" : "÷ (11 − 1)").waitFor();
      const brackets = page.locator(".difference .bracket");
      assert.equal(await brackets.count(), 2);
      for (const bracket of await brackets.all()) {
        const lines = await bracket.evaluate((part) => {
          const range = document.createRange();
          range.selectNodeContents(part);
          return new Set([...range.getClientRects()].map(({ bottom }) => Math.round(bottom))).size;
        });
        assert.equal(lines, 1);
        assert.equal(await isCut(bracket), false);
      }
    }
    assert((await overflow(page)) <= 0);
  }, phone));

test("the sign that was told is there whole at every step", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const last = Number(await slider(page).getAttribute("max"));
    for (let step = 0; step <= last; step += 1) {
      await slider(page).fill(String(step));
      await stepIs(page, step);
      for (const board of ["adversarial", "cooperative"]) {
        const panel = page.locator(`.panel.${board}`);
        assert.equal(await isCut(panel.locator(".latest")), false, `step ${step}`);
        if (step === 0) continue;
        assert.equal(await isCut(panel.locator(".latest b")), false, `step ${step}`);
        const symbol = panel.locator(".symbols .now");
        const [row, box] = [await panel.locator(".symbols").boundingBox(), await symbol.boundingBox()];
        assert(row && box && box.x >= row.x - 0.5 && box.x + box.width <= row.x + row.width + 0.5, `step ${step}`);
        assert.equal(await isCut(symbol), false);
      }
    }
  }, phone));

test("the sign that was told stays in sight when the screen is turned", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    for (const width of [390, 844, 390]) {
      await page.setViewportSize({ width, height: 1234 - width });
      await page.waitForFunction(() =>
        [...document.querySelectorAll(".panel:not(.actor) .symbols")].every((row) => {
          const [outer, inner] = [row, row.querySelector(".now") ?? row].map((part) => part.getBoundingClientRect());
          return outer && inner && inner.left >= outer.left - 0.5 && inner.right <= outer.right + 0.5;
        }),
      );
    }
  }, at(844)));

test("who plays the enemy on a phone has its board alone, and large", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    const box = await page.locator('svg[data-board="adversarial"]').boundingBox();
    assert((box?.width ?? 0) > 240, `a board of ${box?.width} pixels`);
    assert.equal(await page.getByText("Covered while you are the enemy.").first().isVisible(), false);
  }, phone));

test("names that go on and on keep everything in its place, and can be read in full", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const name = "a name that goes on and on ".repeat(12).trim();
    const goals = [
      { name, cell: [3, 0] },
      { name: "G2", cell: [0, 0] },
    ];
    const sensor = { north: name, south: "s", east: "e", west: "w" };
    await useDocument(
      page,
      grid({ goals, true_goal: name, observers: { adversarial: { sensor }, cooperative: { sensor } } }),
    );
    await page.getByRole("button", { name, exact: true }).first().waitFor();
    await statusIs(page, "optimal");
    await openTab(page, "Steps");
    const rows = page.locator(".steps tbody tr");
    const heights = await rows.evaluateAll((all) => all.map((row) => row.getBoundingClientRect().height));
    assert(Math.max(...heights) < 45, `rows of ${Math.max(...heights)} pixels`);
    const width = await page.locator(".steps table").evaluate((table) => table.scrollWidth);
    assert(width < 900, `a table of ${width} pixels`);
    const goal = page.locator("table.goals tbody tr").first();
    // Three lines of the name, and the words beside it.
    const height = await goal.evaluate((row) => row.getBoundingClientRect().height);
    assert(height < 150, `a row of ${height} pixels`);
    assert.equal((await goal.locator(".name").getAttribute("title"))?.startsWith(name), true);
    assert.equal(await goal.locator(".name").textContent(), name);
    assert.equal(await rows.last().getByText(name, { exact: true }).first().getAttribute("title"), name);
    await goal.locator(".name").click();
    const story = page.locator(".story", { hasText: "…" });
    assert((await story.evaluate((part) => part.getBoundingClientRect().height)) < 160);
    await openTab(page, "Play");
    await press(page, "Start guessing");
    const choice = page.locator(".next button").first();
    assert((await choice.evaluate((part) => part.getBoundingClientRect().height)) < 60);
    await page.getByRole("button", { name, exact: true }).waitFor();
    assert((await overflow(page)) <= 0);
  }, phone));

test("what can't be done is said once", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.getByLabel("Plan length").fill("3");
    await statusIs(page, "infeasible");
    await page.getByText("No plan can do what is asked.").waitFor();
    assert.equal(await page.getByText("No plan yet.").count(), 0);
    assert.equal((await page.locator(".difference .after").textContent())?.trim(), "No plan can do what is asked.");
  }));

for (const [width, height] of [
  [390, 844],
  [640, 400],
  [1280, 900],
] as const) {
  test(`taking over brings the agent's board and what can be done into view, ${width} by ${height}`, () =>
    visit(
      async ({ page }) => {
        await statusIs(page, "optimal");
        await openTab(page, "Play");
        await page.getByRole("button", { name: "Take over" }).scrollIntoViewIfNeeded();
        await press(page, "Take over");
        await stepIs(page, 0);
        const seen = (selector: string) =>
          page.waitForFunction((selector) => {
            const part = document.querySelector(selector)?.getBoundingClientRect();
            const bar = document.querySelector(".stepper")?.getBoundingClientRect();
            return part !== undefined && bar !== undefined && part.top >= 0 && part.bottom <= bar.top + 1;
          }, selector);
        for (const part of [".panel.actor svg.board", ".walk-controls", '.panel.actor [data-goal="G1"]'])
          await seen(part);
        const byKey = page.getByText("Use the arrow keys", { exact: false });
        assert.equal(await byKey.isVisible(), width > 640, "keys are spoken of where there are some");
        await press(page, "north");
        await stepIs(page, 1);
        for (const part of [".panel.actor svg.board", ".walk-controls"]) await seen(part);
      },
      { viewport: { width, height }, reducedMotion: "reduce" },
    ));
}

test("at twice the size the agent's board is no smaller than the observers'", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      for (const problem of [null, figure1]) {
        if (problem !== null) await useDocument(page, problem);
        await page
          .locator(problem === null ? "svg.board" : "svg.delivery")
          .first()
          .waitFor();
        const [actor = 0, ...others] = await page
          .locator(".stage svg[data-board]")
          .evaluateAll((boards) => boards.map((board) => board.getBoundingClientRect().height));
        assert(others.length === 2 && others.every((other) => other <= actor + 1), `${actor} beside ${others}`);
        assert(actor >= 200, `a board of ${actor} pixels`);
      }
    },
    { viewport: { width: 640, height: 400 } },
  ));

test("tabs that can't be opened while guessing look like it", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    const look = (tab: string) =>
      page.getByRole("tab", { name: tab, exact: true }).evaluate((part) => Number(getComputedStyle(part).opacity));
    assert((await look("Solve")) < 0.6);
    assert.equal(await look("Play"), 1);
  }));

test("in a frame of 560 pixels the steps cover no goal", () =>
  visit(
    async ({ page }) => {
      for (const problem of ["eight-by-eight", "delivery", "box-pushing"]) {
        await page.goto(`${address}?problem=${problem}&hide=intro,tools,workbench,goals,footer`);
        await statusIs(page, "optimal");
        const covered = await page.evaluate(() => {
          const bar = document.querySelector(".stepper")?.getBoundingClientRect();
          return [...document.querySelectorAll(".survivors li, .difference .value")]
            .filter((part) => {
              const { top, bottom } = part.getBoundingClientRect();
              return bar !== undefined && bottom > bar.top + 1 && top < bar.bottom - 1;
            })
            .map((part) => part.textContent);
        });
        assert.deepEqual(covered, [], problem);
      }
    },
    { viewport: { width: 1000, height: 560 } },
  ));
