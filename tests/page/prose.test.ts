// The prose around a playground: what a click sets although it was set before, and fields of every kind.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { startHost } from "./support/host.js";

const home = await startHost();
home.own.set("lesson/problem.json", { body: grid() });

async function lesson(page: Page, prose: string, asked = `problem="corridor"`): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en"><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <script type="module" src="../mo-copp-playground.js"></script>
      <p>${prose}</p><mo-copp-playground id="one" ${asked} link="off"></mo-copp-playground>`,
  });
  await page.goto(`${home.address}lesson/page.html`);
  await ready(page);
}

const ready = (page: Page, more = "") =>
  page.waitForSelector(`#one:is([data-status=optimal], [data-status=solved])${more}`);
const titled = (page: Page, title: string) => page.locator("#one .title", { hasText: title }).first().waitFor();
const forOne = `data-mo-copp-for="one"`;

test("a link opens, shows and solves what it says, however often it is clicked", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<button id="problem" ${forOne} data-mo-copp-set-problem="head-fake">The head fake</button>
       <button id="both" ${forOne} data-mo-copp-set-problem="head-fake" data-mo-copp-set-step="1">Its first step</button>
       <button id="plan" ${forOne} data-mo-copp-set-plan="Straight there">Straight</button>
       <button id="solver" ${forOne} data-mo-copp-set-solver="search">Search</button>
       <button id="src" ${forOne} data-mo-copp-set-src="problem.json">Ours</button>`,
    );
    const one = page.locator("#one");
    for (let time = 0; time < 2; time += 1) {
      await page.locator("#problem").click();
      await titled(page, "Head fake");
      await one.getByRole("button", { name: "Next problem" }).click();
      await titled(page, "The paper’s delivery");
    }
    for (let time = 0; time < 2; time += 1) {
      await page.locator("#both").click();
      await titled(page, "Head fake");
      await ready(page, '[data-step="1"]');
      await one.getByRole("button", { name: "Next problem" }).click();
      await titled(page, "The paper’s delivery");
    }
    await page.locator("#problem").click();
    await titled(page, "Head fake");
    for (let time = 0; time < 2; time += 1) {
      await page.locator("#plan").click();
      await one.locator('button[aria-pressed="true"]', { hasText: "Straight there" }).waitFor();
      await one.getByRole("button", { name: "Head fake", exact: true }).click();
      await one.locator('button[aria-pressed="true"]', { hasText: /^\s*Head fake\s*$/ }).waitFor();
    }
    for (let time = 0; time < 2; time += 1) {
      await page.locator("#solver").click();
      await page.waitForFunction(() => {
        const selects = [...(document.querySelector("#one")?.shadowRoot?.querySelectorAll("select") ?? [])];
        return selects.some(({ value }) => value === "search");
      });
      await page.waitForFunction(
        () => (document.querySelector("#one") as HTMLElement & { state: { form?: object } }).state.form !== undefined,
      );
      await one.getByLabel("Solver").selectOption("exact");
    }
    for (let time = 0; time < 2; time += 1) {
      await page.locator("#src").click();
      await one.locator('[data-board=actor] [data-cell="3,2"]').waitFor({ state: "attached" });
      await page.waitForFunction(
        () =>
          document.querySelector("#one")?.shadowRoot?.querySelectorAll("[data-board=actor] [data-cell]").length === 12,
      );
      await one.getByRole("button", { name: "Next problem" }).click();
      await titled(page, "The paper’s gridworld");
    }
  }));

test("fields of every kind show a step and set it, and keep what the page wrote in them", () =>
  visit(async ({ page }) => {
    const options = [0, 2, 4].map((step) => `<option value="${step}">After ${step}</option>`).join("");
    const show = `${forOne} data-mo-copp-show="step"`;
    await lesson(
      page,
      `<select id="select" ${show}><option value="">Choose</option>${options}</select>
       <input id="radio-1" type="radio" name="at" value="1" ${show}><input id="radio-3" type="radio" name="at" value="3" ${show}>
       <textarea id="textarea" ${show}></textarea> <output id="output" ${show}></output>
       <progress id="progress" ${show}></progress> <meter id="meter" ${show}></meter>
       <input id="file" type="file" ${show}> <label id="label" ${show}>Step <input id="inner" type="number" ${show}></label>
       <fieldset id="fieldset" ${show}><select><option>Own</option></select></fieldset>`,
    );
    await ready(page, '[data-step="5"]');
    const ids = ["select", "textarea", "output", "progress", "meter", "inner", "radio-1", "radio-3"];
    const shown = () =>
      page.evaluate((ids) => {
        const values = ids.map((id) => [id, (document.getElementById(id) as HTMLInputElement).value]);
        const checked = [...document.querySelectorAll<HTMLInputElement>("[type=radio]:checked")].map(({ id }) => id);
        const { max } = document.querySelector("#progress") as HTMLProgressElement;
        const own = [
          document.querySelectorAll("#select option").length,
          document.querySelector("fieldset option")?.textContent,
        ];
        return { ...Object.fromEntries(values), checked, max, own };
      }, ids);
    const all = (step: number, select: string, checked: string[]) => ({
      ...{ select, checked, max: 5, own: [4, "Own"], "radio-1": "1", "radio-3": "3" },
      ...{ textarea: String(step), output: String(step), progress: step, meter: step, inner: String(step) },
    });
    assert.deepEqual(await shown(), all(5, "", []));
    await page.locator("#select").selectOption("2");
    await ready(page, '[data-step="2"]');
    assert.deepEqual(await shown(), all(2, "2", []));
    await page.locator("#radio-3").check();
    await ready(page, '[data-step="3"]');
    assert.deepEqual(await shown(), all(3, "", ["radio-3"]));
    // Nothing is chosen yet.
    await page.locator("#select").selectOption("");
    await page.locator("#textarea").fill("4");
    await ready(page, '[data-step="4"]');
    assert.deepEqual(await shown(), all(4, "4", []));
    await page.locator("#inner").fill("1");
    await ready(page, '[data-step="1"]');
    assert.deepEqual(await shown(), all(1, "", ["radio-1"]));
    assert.equal(await page.locator("#one").getByRole("alert").textContent(), "");
  }));
