// `loading="lazy"`: nothing is loaded before the playground can be seen, or the page says that it is wanted at once.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { address } from "./support/site.js";

const one = `<mo-copp-playground id="one" problem="corridor" link="off" loading="lazy"></mo-copp-playground>`;

async function lesson(page: Page, body: string): Promise<void> {
  await page.route(`${address}lesson/lazy.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><html lang="en"><head><title>Lesson</title>
        <script type="module" src="../mo-copp-playground.js"></script></head><body>${body}</body></html>`,
    }),
  );
  await page.goto(`${address}lesson/lazy.html`);
  await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
}

const drawn = (page: Page) => page.waitForSelector("#one[data-status=optimal]");

/** As long as one that is in sight takes to be loaded, and longer. */
const SOON_MS = 800;

const closed: Record<string, string> = {
  "a height of nothing": "max-height: 0; overflow: hidden",
  "a width of nothing": "width: 0; overflow: hidden",
  "no size": "width: 0; height: 0; overflow: hidden",
  "no display": "display: none",
};

test("what is closed or has no size is loaded once it can be seen", () =>
  visit(async ({ page, requests }) => {
    for (const [name, style] of Object.entries(closed)) {
      for (const around of [true, false]) {
        await lesson(
          page,
          around
            ? `<div id="box" style="${style}">${one}</div>`
            : `<div>${one.replace("id=", `style="${style}" id=`)}</div>`,
        );
        requests.length = 0;
        await page.waitForTimeout(SOON_MS);
        assert.deepEqual(requests, [], `${name}, ${around ? "of the box around" : "of its own"}`);
        await page.locator(around ? "#box" : "#one").evaluate((element) => element.removeAttribute("style"));
        await drawn(page);
      }
    }
  }));

test("what a transform lets grow from nothing is loaded once it can be seen", () =>
  visit(async ({ page, requests }) => {
    for (const [small, large] of [
      ["scale(0)", "scale(1)"],
      ["scaleX(0)", "none"],
      ["rotateY(90deg)", "none"],
    ]) {
      await lesson(page, `<div id="box" style="transform: ${small}">${one}</div>`);
      requests.length = 0;
      await page.waitForTimeout(SOON_MS);
      assert.deepEqual(requests, [], small);
      await page.locator("#box").evaluate((element, large) => {
        (element as HTMLElement).style.transform = large ?? "";
      }, large);
      await drawn(page);
    }
  }));

test("a poster that has no size keeps nothing back", () =>
  visit(async ({ page }) => {
    await lesson(page, one.replace("></", "><span></span></"));
    await drawn(page);
  }));

test("loading that is changed to eager, or taken away, is followed", () =>
  visit(async ({ page, requests }) => {
    for (const change of [
      "one.loading = 'eager'",
      "one.removeAttribute('loading')",
      "one.loading = 'lazy'; one.loading = 'soon'",
    ]) {
      await lesson(page, `<div style="height: 5000px"></div>${one}`);
      requests.length = 0;
      await page.waitForTimeout(SOON_MS);
      assert.deepEqual(requests, []);
      await page.evaluate(change);
      await page.waitForSelector("#one[data-gd]");
    }
    const alert = page.locator("#one").getByRole("alert");
    assert.match((await alert.textContent()) ?? "", /“soon” can’t be used for the attribute loading/);
  }));
