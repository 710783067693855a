// What stands behind the # of a page's address where a playground is a guest: the page's own places and routes stay.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { pack } from "../../www/src/share/packed.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { startHost } from "./support/host.js";
import { addressHolds, stateIn } from "./support/links.js";

const home = await startHost();

/** Places that a page may have in its address; some of them it never has as elements, or has them later. */
const foreign = [
  "%C3%BCbung-2",
  "übung-2",
  "top",
  "TOP",
  "old",
  "a%20b",
  "/route/3",
  "!/old-route",
  "later",
  "100%",
  "2.1-x",
  // Numbered places that the page has later, or never.
  "1.5",
  "1.",
  "1.introduction",
  "1.introduction-to-planning-under-two-kinds-of-eyes-at-once",
  "1.Introduction-To-2-Kinds-Of-Eyes-And-How-They-See-The-Same-Plan",
  "12.34.56",
];

async function lesson(page: Page, fragment = ""): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en"><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <script type="module" src="../mo-copp-playground.js"></script>
      <h2 id="übung-2">Exercise</h2><a name="old"></a><p id="a b"></p><h2 id="2.1-x">Section</h2>
      <mo-copp-playground id="one" problem="corridor"></mo-copp-playground>`,
  });
  await page.goto("about:blank");
  await page.goto(`${home.address}lesson/page.html${fragment}`);
}

const ready = (page: Page, more = "") => page.waitForSelector(`#one[data-status=optimal]${more}`);
const hash = (page: Page) => page.evaluate(() => location.hash);
const alert = (page: Page) => page.locator("#one").getByRole("alert").textContent();

/** As long as the address takes to be written, and longer. */
const rest = (page: Page) => page.waitForTimeout(800);

test("the page's own places and routes are left alone, when it opens and when it goes on", () =>
  visit(async ({ page }) => {
    for (const fragment of ["%C3%BCbung-2", "/route/3", "1.5"]) {
      await lesson(page, `#${fragment}`);
      await ready(page, '[data-step="5"]');
      await rest(page);
      assert.equal(await hash(page), `#${fragment}`);
      assert.equal(await alert(page), "");
    }
    await lesson(page);
    await addressHolds(page, ({ step }) => step === 5);
    for (const fragment of foreign) {
      const kept = await page.evaluate((fragment) => {
        location.hash = fragment;
        return location.hash;
      }, fragment);
      await page.locator("#one").getByRole("button", { name: "First step" }).click();
      await page.locator("#one").getByRole("button", { name: "Last step" }).click();
      if (["top", "later"].includes(fragment)) await rest(page);
      assert.equal(await hash(page), kept);
      assert.equal(await alert(page), "");
      await ready(page, '[data-step="5"]');
    }
  }));

test("a link of the playground is opened and followed there, a damaged one is said, and its state is kept", () =>
  visit(async ({ page }) => {
    const state = { document: grid(), step: 1 };
    await lesson(page, `#${await pack(JSON.stringify(state))}`);
    await ready(page, '[data-step="1"]');
    await page.evaluate(() => document.querySelector("#one")?.setAttribute("step", "0"));
    const right = await addressHolds(page, ({ step, document }) => step === 0 && document === grid());
    assert.equal((await stateIn(right)).document, grid());
    for (const [wrong, words] of [
      [right.slice(0, right.length / 2), /damaged/],
      [right.replace(/^#1/, "#9"), /newer version/],
    ] as const) {
      await page.evaluate((wrong) => {
        location.hash = wrong;
      }, wrong);
      await page.waitForSelector("#one[data-status=error]");
      assert.match((await alert(page)) ?? "", words);
      // What was shown stays, and with the message closed the status is its own again.
      const shown = page.locator("#one");
      assert.equal(await shown.getAttribute("data-step"), "0");
      assert.equal(await shown.locator("[data-board=actor]").count(), 1);
      await shown.getByRole("button", { name: "Close the message" }).click();
      await ready(page, '[data-step="0"]');
      await addressHolds(page, ({ document }) => document === grid());
    }
  }));
