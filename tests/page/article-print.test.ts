// The first print of the article: what it loads shows its end, as what was loaded before.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { address } from "./support/site.js";

interface Figure {
  id: string;
  step: string | undefined;
  /** The step that it begins at, and the number of its last one. */
  begins: string | null;
  last: number;
}

const figures = (page: Page): Promise<Figure[]> =>
  page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("mo-copp-playground")].map((figure) => ({
      id: figure.id,
      step: figure.dataset.step,
      begins: figure.getAttribute("step"),
      last: figure.getAttribute("plan")?.split(",").length ?? 0,
    })),
  );

const dispatch = (page: Page, event: "beforeprint" | "afterprint") =>
  page.evaluate((event) => dispatchEvent(new Event(event)), event);

/** The step that each of them is to show. */
const settled = (page: Page, which: "begins" | "printed") =>
  page.waitForFunction(
    (which) =>
      [...document.querySelectorAll<HTMLElement>("mo-copp-playground")].every((figure) => {
        const begins = figure.getAttribute("step") ?? "0";
        const last = String(figure.getAttribute("plan")?.split(",").length);
        return figure.dataset.step === (which === "printed" && begins === "0" ? last : begins);
      }),
    which,
  );

test("figures that a print loads go to their end for it, and are at their start after it", () =>
  visit(async ({ page }) => {
    await page.goto(`${address}learn/index.html`);
    await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
    const before = await figures(page);
    assert(before.filter(({ step }) => step === undefined).length > 5, `nothing is loaded: ${JSON.stringify(before)}`);
    assert(before.filter(({ begins }) => begins === "0").length > 5, "figures begin at their start");
    await dispatch(page, "beforeprint");
    await settled(page, "printed");
    await dispatch(page, "afterprint");
    await settled(page, "begins");
    // What is loaded after it stays at its start, and the next print is as the first.
    await dispatch(page, "beforeprint");
    await settled(page, "printed");
    await dispatch(page, "afterprint");
    await settled(page, "begins");
  }));

test("a figure that is loaded after a print begins at its start", () =>
  visit(async ({ page }) => {
    await page.goto(`${address}learn/index.html`);
    await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
    await page.evaluate(() => {
      dispatchEvent(new Event("beforeprint"));
      dispatchEvent(new Event("afterprint"));
    });
    await settled(page, "begins");
  }));
