// The table of the steps, and what is said of each step.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { csv } from "../../www/src/steps/csv.js";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { example, replay, solve } from "./support/core.js";
import { grid } from "./support/documents.js";
import { saved } from "./support/downloads.js";
import { openTab, press, slider, statusIs, stepIs, useDocument } from "./support/playground.js";

const { trace } = solve(example, { solver: "exact" });
const region = (page: Page) => page.getByRole("region", { name: "Table of the steps" });
const rows = (page: Page) => region(page).locator("tbody tr");

test("the table says of each step what the core says", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Steps");
    await rows(page).first().waitFor();
    const shown = await rows(page).evaluateAll((all) =>
      all.map((row) => [...row.children].map((cell) => cell.textContent?.trim())),
    );
    const short = new Intl.NumberFormat("en", { maximumFractionDigits: 3 });
    assert.deepEqual(
      shown,
      trace.steps.map(({ action, symbols, beliefs, goals }, step) => [
        String(step),
        action ?? "start",
        ...(["adversarial", "cooperative"] as const).flatMap((role) => [
          symbols[role] ?? "nothing yet",
          String(beliefs[role].length),
          goals[role].join(", ") || "none",
        ]),
        // A goal difference is of a plan: its end alone has one.
        step === trace.steps.length - 1 ? short.format(trace.goal_difference).replace("-", "−") : "",
      ]),
    );
  }));

test("the row of the step shown is marked and in sight, and a row chosen is shown", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await openTab(page, "Steps");
      const inSight = async (step: number) => {
        const row = region(page).locator('tr[aria-current="step"]');
        const number = row.locator("th").getByText(String(step), { exact: true });
        await number.waitFor();
        assert.equal(await row.count(), 1);
        // The table follows in the frame after the step.
        await page.waitForFunction(
          (shown) => {
            const box = shown?.getBoundingClientRect();
            const frame = shown?.closest("[role=region]")?.getBoundingClientRect();
            const head = shown?.closest("table")?.tHead?.getBoundingClientRect();
            return box && frame && head && box.top >= head.bottom - 1 && box.bottom <= frame.bottom + 1;
          },
          await row.elementHandle(),
        );
      };
      for (const step of [0, 9, 15, 16]) {
        await slider(page).fill(String(step));
        await stepIs(page, step);
        await inSight(step);
      }
      await region(page).getByRole("button", { name: "Step 12", exact: true }).press("Enter");
      await stepIs(page, 12);
      await rows(page).nth(13).locator("td").first().click();
      await stepIs(page, 13);
      await inSight(13);
      // The page itself stays where it is.
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert(overflow <= 0, `${overflow} pixels too wide`);
    },
    { viewport: { width: 390, height: 844 } },
  ));

test("the steps are saved for a spreadsheet", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Steps");
    const { name, text } = await saved(page, "Save as CSV");
    assert.equal(name, "eight-by-eight-steps.csv");
    assert.equal(text, csv(trace));
    const lines = text.trimEnd().split("\r\n");
    assert.equal(lines.length, 18);
    assert.equal(lines[1], "0,,,3,,,1,,");
    assert.equal(lines[17], "16,north,vertical,24,G1; G2; G3; G4,north-east,1,G1,1");
  }));

test("no name becomes a formula or another field of the spreadsheet", () => {
  const names = ['=HYPERLINK("http://x")', 'a,b"c', "+1", "plain"];
  const goals = names.map((name, index) => ({ name, cell: [index, 0] }));
  const text = csv(replay(grid({ goals, true_goal: names[0], start: [0, 0], walls: [] }), []));
  assert.equal(text.split("\r\n")[1], `0,,,1,"'=HYPERLINK(""http://x"")",,1,"'=HYPERLINK(""http://x"")",0`);
  assert.match(csv(replay(grid({ goals, true_goal: names[1], start: [1, 0], walls: [] }), [])), /"a,b""c"/);
  assert.match(csv(replay(grid({ goals, true_goal: names[2], start: [2, 0], walls: [] }), [])), /,'\+1,/);
});

test("who plays the enemy sees the enemy's columns, up to the step it has come to", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Steps");
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    // The tab itself is closed meanwhile; nothing of the table is on the page.
    assert.equal(await page.getByRole("tab", { name: "Steps" }).isDisabled(), true);
    assert.equal(await region(page).count(), 0);
  }));

test("steps are said while they are played, unless they are too fast to be said", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.keyboard.press("Home");
    await said(page)
      .getByText(/^Step 0:/)
      .waitFor({ state: "attached" });
    await press(page, "Play");
    for (const step of [1, 2, 3])
      await said(page)
        .getByText(new RegExp(`^Step ${step},`))
        .waitFor({ state: "attached" });
    await page.getByLabel("Speed").selectOption({ label: "4×" });
    await stepIs(page, 16);
    await said(page)
      .getByText(/^Step 16,/)
      .waitFor({ state: "attached" });
  }));

const said = (page: Page) => page.locator("mo-copp-playground > [aria-live=polite]");

test("each step is said once, in words, when one has come to rest", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await press(page, "Last step");
      await said(page)
        .getByText(/^Step 16/)
        .waitFor({ state: "attached" });
      const heard = () => page.evaluate(() => (window as unknown as { heard: string[] }).heard);
      await page.evaluate(() => {
        const region = document.querySelector("mo-copp-playground > [aria-live=polite]");
        const list: string[] = [];
        Object.assign(window, { heard: list });
        if (region)
          new MutationObserver(() => list.push(region.textContent?.trim() ?? "")).observe(region, {
            ...{ childList: true, characterData: true, subtree: true },
          });
      });
      await press(page, "Back one step");
      const { action, symbols, beliefs, goals } = trace.steps[15] ?? assert.fail();
      const survive = (names: string[]) =>
        names.length === 0 ? "no goal is possible now" : names.length === 1 ? `goal ${names[0]} is possible` : null;
      const words =
        `Step 15, ${action}: the enemy was told ${symbols.adversarial}, ${beliefs.adversarial.length} states left, ` +
        `${survive(goals.adversarial)}; the friend was told ${symbols.cooperative}, ` +
        `${beliefs.cooperative.length === 1 ? "1 state" : `${beliefs.cooperative.length} states`} left, ${survive(goals.cooperative)}.`;
      await said(page).getByText(words, { exact: true }).waitFor({ state: "attached" });
      assert.deepEqual(await heard(), [words]);

      // While the slider is held nothing is said; then only where it was let go.
      const box = (await slider(page).boundingBox()) ?? assert.fail();
      await page.mouse.move(box.x + box.width - 30, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + 8, box.y + box.height / 2, { steps: 25 });
      await stepIs(page, 0);
      assert.equal((await heard()).length, 1);
      await page.mouse.up();
      await said(page)
        .getByText(/^Step 0:/)
        .waitFor({ state: "attached" });
      assert.equal((await heard()).length, 2);
    },
    { viewport: { width: 1280, height: 800 } },
  ));

test("a document's names in the table are text, and many goals are counted", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const goals = Array.from({ length: 12 }, (_, index) => ({ name: `<i>${index}</i>`, cell: [3, index % 3] }));
    await useDocument(page, grid({ goals, true_goal: "<i>0</i>" }));
    await page.waitForFunction(() => document.querySelectorAll("tr[data-goal]").length === 12);
    await statusIs(page, "optimal");
    await openTab(page, "Steps");
    assert.equal(await region(page).locator("i").count(), 0);
  }));

test("axe finds no barrier in the table, light and dark", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Steps");
    await press(page, "Forward one step");
    await assertNoBarrier(page, "the table of the steps", { dark: true });
  }));
