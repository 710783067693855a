// The answer that comes with the page: what the cores say, on the boards before there is a core, and no promise of one.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { answer } from "../../scripts/page/opening-answer.mjs";
import initLight, { Problem as LightProblem } from "../../www/pkg-light/mo_copp_light.js";
import type { GridworldDocument } from "../../www/src/problem/types.js";
import { emptyForm, exactOptions } from "../../www/src/state/form.js";
import { visit } from "./support/browser.js";
import { example, solve } from "./support/core.js";
import { dragMouse } from "./support/hands.js";
import { attribute, statusIs, stepIs } from "./support/playground.js";

await initLight({
  module_or_path: readFileSync(new URL("../../www/pkg-light/mo_copp_light_bg.wasm", import.meta.url)),
});

const known = await answer();

test("it is what the light core answers when the page asks for its first problem", () => {
  assert.deepEqual(known.options, exactOptions(emptyForm));
  const problem = new LightProblem(example);
  const run = problem.solve(known.options);
  while (!run.advance(1000));
  const { stats, ...outcome } = run.outcome();
  const { seconds, ...counts } = stats;
  assert(seconds >= 0, String(seconds));
  assert.deepEqual(known.outcome, { ...outcome, stats: counts });
  assert.deepEqual(known.scene, problem.scene());
  assert.deepEqual(known.trace, problem.overview(outcome.plan ?? [], 100));
});

const wasm = (url: URL) => url.pathname.endsWith(".wasm");
const alert = (page: Page) => page.locator("mo-copp-playground").getByRole("alert").first();

test("the first picture takes no core, which follows, and what the person does meanwhile stays", () =>
  visit(async ({ page, requests }) => {
    let letGo: () => void = () => undefined;
    const held = new Promise<void>((resolve) => {
      letGo = resolve;
    });
    await page.context().route(wasm, async (route) => {
      await held;
      await route.continue();
    });
    await page.reload();
    await statusIs(page, "optimal");
    assert.equal(await attribute(page, "data-gd"), String(known.outcome.goal_difference));
    const steps = page.getByRole("slider");
    await steps.press("ArrowRight");
    await steps.press("ArrowRight");
    await stepIs(page, 2);
    letGo();
    await page.waitForEvent("requestfinished", (request) => wasm(new URL(request.url())));
    await page.waitForLoadState("networkidle");
    assert.equal(await attribute(page, "data-step"), "2");
    assert.equal(await attribute(page, "data-status"), "optimal");
    assert(
      requests.some((url) => wasm(new URL(url))),
      requests.join(" "),
    );
  }));

test("a core that does not come is told of before it is needed, what is shown stays, and a click asks again", () =>
  visit(
    async ({ page }) => {
      await page.context().route(wasm, (route) => route.abort());
      await page.reload();
      await alert(page)
        .getByText(/\.wasm could not be loaded/)
        .waitFor();
      assert.equal(await page.locator("[data-board=adversarial]").count(), 1);
      await page.context().unrouteAll();
      await alert(page).getByRole("button", { name: "Try again" }).click();
      await statusIs(page, "optimal");
      assert.equal(await page.getByText(/could not be loaded/).count(), 0);
    },
    { quiet: false },
  ));

test("a plan that is asked for before there is a core is shown once it is there", () =>
  visit(async ({ page }) => {
    await page.context().route(wasm, async (route) => {
      await new Promise((resolve) => setTimeout(resolve, 1000));
      await route.continue();
    });
    await page.goto(`${page.url().split("?")[0]}?problem=eight-by-eight&plan=north,north,east&step=2`);
    await page.waitForSelector('mo-copp-playground[data-step="2"][data-status=optimal]');
    await page.locator('input[type="range"][max="3"]').waitFor();
  }));

test("an edit made before there is a core is answered by it", () =>
  visit(async ({ page }) => {
    await page.reload();
    await statusIs(page, "optimal");
    await dragMouse(page, "actor", [
      [2, 1],
      [2, 0],
    ]);
    await page.waitForFunction(() => {
      const element = document.querySelector("mo-copp-playground") as HTMLElement & { document: GridworldDocument };
      return element.document.walls?.some(([column, row]) => column === 2 && row === 0);
    });
    await statusIs(page, "optimal");
    const edited = await page
      .locator("mo-copp-playground")
      .evaluate((element) => JSON.stringify((element as HTMLElement & { document: object }).document));
    const { outcome } = solve(edited, { solver: "exact" });
    assert.equal(await attribute(page, "data-gd"), String(outcome.goal_difference));
  }));
