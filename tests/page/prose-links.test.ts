// Links and fields of the prose that ask for another problem: the one set last wins, and brings nothing of the one before.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { startHost } from "./support/host.js";

const home = await startHost();
home.own.set("lesson/problem.json", { body: grid() });

async function lesson(page: Page, prose: string, asked: string, inside = ""): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en"><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <script type="module" src="../mo-copp-playground.js"></script>
      <p>${prose}</p><mo-copp-playground id="one" ${asked} link="off">${inside}</mo-copp-playground>`,
  });
  await page.goto(`${home.address}lesson/page.html`);
}

const ready = (page: Page, more = "") =>
  page.waitForSelector(`#one:is([data-status=optimal], [data-status=solved])${more}`);
const titled = (page: Page, title: string) => page.locator("#one .title", { hasText: title }).first().waitFor();
const cells = (page: Page, count: number) =>
  page.waitForFunction(
    (count) =>
      document.querySelector("#one")?.shadowRoot?.querySelectorAll("[data-board=actor] [data-cell]").length === count,
    count,
  );
const link = (id: string, set: Record<string, string | number>) =>
  `<button id="${id}" data-mo-copp-for="one" ${Object.entries(set)
    .map(([name, value]) => `data-mo-copp-set-${name}="${value}"`)
    .join(" ")}>${id}</button> `;
/** Which links say that they are of what is shown. */
const current = (page: Page) =>
  page.evaluate(() => [...document.querySelectorAll("[aria-current=step]")].map(({ id }) => id).sort());
const said = (page: Page) => page.locator("#one").getByRole("alert").first();
const marked = (page: Page, ids: string[]) =>
  page.waitForFunction(
    (ids) =>
      [...document.querySelectorAll("[aria-current=step]")]
        .map(({ id }) => id)
        .sort()
        .join() === ids,
    [...ids].sort().join(),
  );

const links =
  link("fake", { problem: "head-fake" }) +
  link("corridor", { problem: "corridor" }) +
  link("src", { src: "problem.json" }) +
  link("gone", { src: "missing.json" });

test("of src and problem the one that was set last is opened, by links and by scripts", () =>
  visit(
    async ({ page }) => {
      // Written together in the page, src goes before problem.
      await lesson(page, links, `src="problem.json" problem="corridor"`);
      await ready(page, '[data-step="5"]');
      await cells(page, 12);
      await page.locator("#corridor").click();
      await titled(page, "One step too far");
      await page.locator("#src").click();
      await cells(page, 12);
      await page.locator("#fake").click();
      await titled(page, "Head fake");
      const set = (change: Record<string, string>) =>
        page.locator("#one").evaluate((one, change) => void Object.assign(one, change), change);
      await set({ src: "problem.json" });
      await cells(page, 12);
      await set({ problem: "corridor" });
      await titled(page, "One step too far");
      await set({ problem: "head-fake", src: "problem.json" });
      await cells(page, 12);
      // What could not be had is no longer asked for.
      await lesson(page, links, `src="missing.json"`);
      await said(page).getByText("was answered with 404").waitFor();
      await page.locator("#fake").click();
      await titled(page, "Head fake");
      await ready(page);
      assert.equal((await said(page).textContent())?.trim(), "", "the message goes");
      await page.locator("#gone").click();
      await said(page).getByText("was answered with 404").waitFor();
      await page.locator("#fake").click();
      await ready(page);
      // A document in the element is what it begins with.
      await lesson(page, links, "", `<script type="application/json">${grid()}</script>`);
      await ready(page);
      await page.locator("#fake").click();
      await titled(page, "Head fake");
    },
    { quiet: false },
  ));

test("a link that is clicked before the playground is loaded is the last one, too", () =>
  visit(async ({ page }) => {
    await lesson(page, links, `src="problem.json" loading="lazy" style="display: block; margin-top: 5000px"`);
    await page.waitForSelector("#one[data-status=idle]");
    await page.locator("#fake").click();
    await titled(page, "Head fake");
  }));

test("a link to another problem brings no plan and no step of the one before", () =>
  visit(async ({ page }) => {
    const straight = { problem: "head-fake", plan: "Straight there", step: 1 };
    await lesson(page, links + link("straight", straight), `problem="corridor" step="1" plan="wait"`);
    await page.waitForSelector('#one[data-step="1"]');
    await page.locator("#fake").click();
    await ready(page, '[data-step="16"]');
    await page.locator("#straight").click();
    await ready(page, '[data-step="1"]');
    await page.locator("#corridor").click();
    await ready(page, '[data-step="5"]');
    await page.locator("#straight").click();
    await ready(page, '[data-step="1"]');
    await page.locator("#src").click();
    await cells(page, 12);
    await ready(page, '[data-step="5"]');
    assert.equal((await said(page).textContent())?.trim(), "", "no plan of another problem is tried");
  }));

test("only links to what is shown say so", () =>
  visit(
    async ({ page }) => {
      await lesson(
        page,
        link("step", { step: 1 }) +
          link("plan", { plan: "Straight there", step: 1 }) +
          link("head", { problem: "head-fake", step: 1 }) +
          link("both", { problem: "head-fake", plan: "Straight there", step: 1 }) +
          link("other", { src: "problem.json", step: 1 }) +
          link("lost", { src: "missing.json", step: 1 }),
        `problem="head-fake" step="1"`,
      );
      await ready(page, '[data-step="1"]');
      await marked(page, ["step", "head"]);
      await page.locator("#plan").click();
      await marked(page, ["step", "plan", "both"]);
      await page.locator("#head").click();
      await marked(page, ["step", "head"]);
      await page.locator("#other").click();
      await cells(page, 12);
      await marked(page, ["step", "other"]);
      await page.locator("#lost").click();
      await said(page).getByText("was answered with 404").waitFor();
      assert.deepEqual(await current(page), ["step"], "what could not be had is not shown");
      await page.locator("#both").click();
      await marked(page, ["step", "plan", "both"]);
      // Where both are written in the page, src is what is shown.
      await lesson(
        page,
        link("head", { problem: "head-fake", step: 1 }),
        `problem="head-fake" src="problem.json" step="1"`,
      );
      await ready(page, '[data-step="1"]');
      assert.deepEqual(await current(page), []);
    },
    { quiet: false },
  ));

test("a checkbox sets what it says and gives it back, and fields follow what is set elsewhere", () =>
  visit(async ({ page }) => {
    const show = (name: string) => `data-mo-copp-for="one" data-mo-copp-show="${name}"`;
    const scheme = (name: string) => page.waitForSelector(`#one[data-scheme=${name}]`);
    const fields = `<input id="dark" type="checkbox" value="dark" ${show("theme")}>
      <select id="theme" ${show("theme")}><option>light</option><option>dark</option><option>auto</option></select>
      <select id="solver" ${show("solver")}><option>exact</option><option>search</option></select>`;
    await lesson(page, fields + link("light", { theme: "light" }), `problem="corridor"`);
    await ready(page);
    const dark = page.locator("#dark");
    const theme = page.locator("#theme");
    assert.equal(await theme.inputValue(), "auto");
    await dark.check();
    await scheme("dark");
    assert.equal(await theme.inputValue(), "dark");
    await dark.uncheck();
    await scheme("light");
    assert.equal(await page.locator("#one").getAttribute("theme"), null);
    await theme.selectOption("dark");
    await scheme("dark");
    assert.equal(await dark.isChecked(), true);
    await page.locator("#light").click();
    await scheme("light");
    assert.deepEqual([await dark.isChecked(), await theme.inputValue()], [false, "light"]);
    await dark.check();
    await scheme("dark");
    await dark.uncheck();
    assert.equal(await page.locator("#one").getAttribute("theme"), "light", "what it was before");
    await page.locator("#one").evaluate((one) => one.setAttribute("solver", "search"));
    await ready(page);
    assert.equal(await page.locator("#solver").inputValue(), "search");
  }));

test("a number field takes a step as it may be typed, and left with another number shows the step that is shown", () =>
  visit(async ({ page }) => {
    const field = page.locator("#field");
    await lesson(
      page,
      `<input id="field" type="number" data-mo-copp-for="one" data-mo-copp-show="step">`,
      `problem="head-fake"`,
    );
    await ready(page, '[data-step="16"]');
    await field.fill("1e1");
    await ready(page, '[data-step="10"]');
    for (const typed of ["-5", "", "1.5"]) {
      await field.fill(typed);
      assert.equal(await field.inputValue(), typed);
      await field.press("Tab");
      assert.equal(await field.inputValue(), "10", typed);
    }
    await field.fill("3");
    await ready(page, '[data-step="3"]');
    assert.equal((await said(page).textContent())?.trim(), "");
  }));
