// Links: the whole state in the address, restored from it, and what becomes of links that are not right.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { pack } from "../../www/src/share/packed.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { documentOf } from "./support/gallery.js";
import { addressHolds, follow, stateIn } from "./support/links.js";
import {
  attribute,
  choose,
  drawn,
  openTab,
  press,
  slider,
  statusIs,
  stepIs,
  useDocument,
} from "./support/playground.js";
import { address } from "./support/site.js";
import { textIs } from "./support/text.js";

const says = async (page: Page, words: RegExp) => {
  await statusIs(page, "error");
  assert.match((await page.getByRole("alert").textContent()) ?? "", words);
};

/** The text of the option that is chosen. */
const chosenIn = (page: Page, label: string) =>
  page.getByLabel(label).evaluate((field) => (field as HTMLSelectElement).selectedOptions[0]?.textContent);

test("everything that is shown comes back from the link", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, grid());
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 12);
    await openTab(page, "Solve");
    await page.getByLabel("Plan length").fill("7");
    await choose(page, "Solver", "search");
    await press(page, "Solve");
    await statusIs(page, "solved");
    await slider(page).fill("3");
    await stepIs(page, 3);
    await openTab(page, "Steps");
    const hash = await addressHolds(page, ({ step, tab }) => step === 3 && tab === "steps");
    const before = { drawn: await drawn(page), gd: await attribute(page, "data-gd"), plan: (await stateIn(hash)).plan };
    assert.equal(before.plan.length, 7);

    await follow(page, hash);
    await stepIs(page, 3);
    assert.deepEqual(await drawn(page), before.drawn);
    assert.equal(await attribute(page, "data-gd"), before.gd);
    assert.equal(await page.getByRole("tab", { name: "Steps" }).getAttribute("aria-selected"), "true");
    await openTab(page, "Solve");
    assert.equal(await page.getByLabel("Plan length").inputValue(), "7");
    assert.equal(await page.getByLabel("Solver").inputValue(), "search");
    await openTab(page, "Document");
    await textIs(page, grid());
    // The same state has the same address again.
    await openTab(page, "Steps");
    assert.equal(await addressHolds(page, ({ tab, step }) => tab === "steps" && step === 3), hash);
  }));

test("a plan of another solver keeps its name, also where it is the best one's", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, grid());
    await openTab(page, "Compare");
    await press(page, "Compare all solvers");
    await page.getByRole("button", { name: "Exact search", exact: true }).click();
    const hash = await addressHolds(page, ({ title }) => title === "the plan of Exact search");
    await follow(page, hash);
    await page.getByText("On the boards: the plan of Exact search.").waitFor();
  }));

test("a link of the guessing game begins another round", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    const hash = await addressHolds(page, ({ mode, plan }) => mode === "guess" && plan === undefined);
    await follow(page, hash);
    await page.getByText("Which goal is it after?").waitFor();
    assert.equal(await page.locator("[data-true-goal]").count(), 0);
  }));

test("after a guess the link shows the goal that was drawn, and the way to it", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await useDocument(page, grid());
      await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 12);
      await openTab(page, "Play");
      await press(page, "Start guessing");
      await page.locator(".play.guess").getByRole("button", { name: "G1", exact: true }).click();
      await page.getByText("No: it was G2").waitFor();
      const before = { drawn: await drawn(page), gd: await attribute(page, "data-gd") };
      const hash = await addressHolds(page, ({ document }) => JSON.parse(String(document)).true_goal === "G2");
      const state = await stateIn(hash);
      await follow(page, hash);
      await statusIs(page, "optimal");
      await stepIs(page, state.plan.length);
      assert.deepEqual(await drawn(page), before.drawn);
      assert.equal(await attribute(page, "data-gd"), before.gd);
      assert.equal(await page.locator('table.goals [data-true-goal][data-goal="G2"]').count(), 1);
    },
    // The second goal is drawn.
    { before: (page) => page.addInitScript("crypto.getRandomValues = (values) => values.fill(1)") },
  ));

test("a named plan and its step come back", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await press(page, "Straight there");
    await stepIs(page, 14);
    await slider(page).fill("9");
    const hash = await addressHolds(page, ({ step, title }) => step === 9 && title === "Straight there");
    await follow(page, hash);
    await stepIs(page, 9);
    await page.locator('button[aria-pressed="true"]', { hasText: "Straight there" }).waitFor();
    assert.equal(await attribute(page, "data-gd"), String(2 / 3));
  }));

test("a named plan that is the best one of another true goal comes back as that", () =>
  visit(async ({ page }) => {
    await page.goto(`${address}?problem=delivery`);
    await page.waitForSelector('mo-copp-playground[data-gd="1"]');
    await press(page, "One from each");
    await page.waitForSelector('mo-copp-playground[data-gd="0.4"]');
    const button = page.locator('button[aria-pressed="true"]', { hasText: "One from each" });
    await button.waitFor();
    const hash = await addressHolds(page, ({ document }) => JSON.parse(String(document)).true_goal === "a1+b1");
    await follow(page, hash);
    await button.waitFor();
    assert.equal(await attribute(page, "data-gd"), "0.4");
    // One that was made while the solver had not found the plan again.
    const state = { ...(await stateIn(hash)), title: "the plan of the link" };
    await follow(page, `#${await pack(JSON.stringify(state))}`);
    await button.waitFor();
  }));

test("a walk comes back, and goes on", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Play");
    await press(page, "Take over");
    await page.getByRole("button", { name: "north", exact: true }).click();
    await stepIs(page, 1);
    await page.getByRole("button", { name: "east", exact: true }).click();
    await stepIs(page, 2);
    const hash = await addressHolds(page, ({ mode, plan }) => mode === "walk" && String(plan) === "north,east");
    await follow(page, hash);
    await stepIs(page, 2);
    await page.getByRole("button", { name: "Stop walking" }).waitFor();
    await page.getByRole("button", { name: "north", exact: true }).click();
    await stepIs(page, 3);
  }));

test("a problem of 32 by 32 cells has a link that works", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.getByTitle("All problems").click();
    await page.getByRole("button", { name: "A city at night" }).click();
    await page.waitForSelector('mo-copp-playground[data-step="44"]');
    const hash = await addressHolds(page, ({ document, step }) => document === documentOf("city") && step === 44);
    assert(hash.length < 4000, `${hash.length} characters`);
    await follow(page, hash);
    await page.waitForSelector('mo-copp-playground[data-step="44"][data-gd="1"]');
    assert.equal(await page.locator('[data-board="actor"] [data-cell]').count(), 1024);
  }));

test("links that are not right say so, and leave what is on the page", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, grid());
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 12);
    await statusIs(page, "optimal");
    const before = await drawn(page);
    const right = await addressHolds(page, ({ document }) => document === grid());
    const bad: [string, RegExp][] = [
      [right.slice(0, right.length / 2), /damaged/],
      [right.replace(/^#1/, "#9"), /newer version/],
      ["#1.", /damaged/],
      ["#nonsense", /damaged/],
      [`#${await pack("not JSON")}`, /damaged/],
      [`#${await pack(JSON.stringify({ step: 3 }))}`, /holds no problem/],
      [`#${await pack(JSON.stringify({ document: "{" }))}`, /\S+ \S+ \S+/],
      [`#${await pack(JSON.stringify({ document: grid({ start: [9, 9] }) }))}`, /start/],
    ];
    for (const [hash, words] of bad) {
      await page.evaluate((wrong) => {
        location.hash = wrong;
      }, hash);
      await says(page, words);
      assert.deepEqual(await drawn(page), before);
      // The address follows what is on the page.
      await addressHolds(page, ({ document }) => document === grid());
      await press(page, "First step");
      await press(page, "Last step");
    }
  }));

test("a damaged link to begin with: the page says so and shows what it begins with", () =>
  visit(async ({ page }) => {
    await follow(page, "#1.AAAA.zzz");
    await says(page, /damaged/);
    await page.getByText("The paper’s gridworld").first().waitFor();
    assert.equal(await page.locator('[data-board="actor"] [data-cell]').count(), 64);
    await follow(page, `#${await pack(JSON.stringify({ document: grid({ true_goal: "nowhere" }) }))}`);
    await says(page, /true_goal/);
    assert.equal(await page.locator('[data-board="actor"] [data-cell]').count(), 64);
  }));

test("what a link holds of a wrong kind is left out", () =>
  visit(async ({ page }) => {
    const state = {
      document: grid(),
      form: { solver: "magic", k: "many", horizon: 7, constructor: "x", j: "2" },
      plan: [1, 2],
      step: 1e9,
      tab: "<b>",
      mode: "god",
      title: 7,
      extra: 7,
      patience: -1,
    };
    await follow(page, `#${await pack(JSON.stringify(state))}`);
    await statusIs(page, "optimal");
    assert.equal(await page.getByLabel("Solver").inputValue(), "exact");
    assert.equal(await page.getByLabel("Friend keeps at most").inputValue(), "2");
    assert.equal(await page.getByLabel("Enemy keeps at least").inputValue(), "");
    const last = await page.getByRole("slider").getAttribute("max");
    await stepIs(page, Number(last));
    await openTab(page, "Compare");
    assert.equal(await chosenIn(page, "Each may take"), "10 seconds");
    await openTab(page, "Trade-off");
    assert.equal(await chosenIn(page, "Up to"), "12");
  }));

test("how far the trade-off looks and how long the comparison may take come back", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, grid());
    await openTab(page, "Compare");
    for (const [label, seconds] of [
      ["2 seconds", 2],
      ["as long as it likes", 0],
    ] as const) {
      await page.getByLabel("Each may take").selectOption({ label });
      await addressHolds(page, ({ patience }) => patience === seconds);
    }
    await openTab(page, "Trade-off");
    await page.getByLabel("Up to").selectOption("24");
    const hash = await addressHolds(page, ({ extra, patience }) => extra === 24 && patience === 0);
    await follow(page, hash);
    assert.equal(await chosenIn(page, "Up to"), "24");
    await openTab(page, "Compare");
    assert.equal(await chosenIn(page, "Each may take"), "as long as it likes");
    // A link without them is of a page where nobody touched them.
    const { extra, patience, ...older } = await stateIn(hash);
    assert.deepEqual([extra, patience], [24, 0]);
    await follow(page, `#${await pack(JSON.stringify(older))}`);
    assert.equal(await chosenIn(page, "Up to"), "12");
  }));

test("a plan that does not fit the link's problem is said, and the problem is shown", () =>
  visit(async ({ page }) => {
    await follow(page, `#${await pack(JSON.stringify({ document: grid(), plan: ["fly"], step: 1 }))}`);
    await says(page, /fly/);
    assert.equal(await page.locator('[data-board="actor"] [data-cell]').count(), 12);
  }));

test("names from a link are text", () =>
  visit(async ({ page }) => {
    const name = "<img src=x onerror=alert(1)>";
    page.on("dialog", () => assert.fail("a script ran"));
    const goals = [
      { name, cell: [3, 0] },
      { name: "G2", cell: [0, 0] },
    ];
    const state = { document: grid({ goals, true_goal: name }), plan: ["east", "north"], title: name, step: 1 };
    await follow(page, `#${await pack(JSON.stringify(state))}`);
    await page.getByRole("rowheader", { name }).waitFor();
    await stepIs(page, 1);
    assert.equal(await page.locator("img").count(), 0);
  }));

test("another link followed on the same page is opened, and going back comes back", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const first = await addressHolds(page, () => true);
    const other = `#${await pack(JSON.stringify({ document: grid(), step: 0 }))}`;
    await page.evaluate((hash) => {
      location.hash = hash;
    }, other);
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 12);
    await stepIs(page, 0);
    await page.goBack();
    await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 64);
    assert.deepEqual((await stateIn(first)).document, documentOf("eight-by-eight"));
  }));

test("the address waits while something is dragged or played, and is written seldom", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await press(page, "Last step");
      await addressHolds(page, ({ step }) => step === 16);
      const writes = () => page.evaluate(() => (window as unknown as { writes: number[] }).writes.length);
      const before = await writes();
      const box = (await slider(page).boundingBox()) ?? assert.fail();
      await page.mouse.move(box.x + box.width - 8, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + 30, box.y + box.height / 2, { steps: 30 });
      await page.waitForFunction(
        () => Number(document.querySelector("mo-copp-playground")?.getAttribute("data-step")) < 3,
      );
      assert.equal(await writes(), before);
      await page.mouse.up();
      await addressHolds(page, ({ step }) => Number(step) < 3);
      assert.equal(await writes(), before + 1);
      await press(page, "Play");
      await stepIs(page, 4);
      assert.equal(await writes(), before + 1);
      await press(page, "Pause");
      await addressHolds(page, ({ step }) => Number(step) >= 4);
      assert.equal(await writes(), before + 2);
    },
    {
      before: (page) =>
        page.addInitScript(`
          window.writes = [];
          const replace = history.replaceState;
          history.replaceState = function (...args) {
            window.writes.push(performance.now());
            return replace.apply(this, args);
          };
        `),
    },
  ));
