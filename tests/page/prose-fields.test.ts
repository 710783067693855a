// Fields of the prose that hold what can't be used say so themselves; a step beyond the last is the last, however it is set.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { startHost } from "./support/host.js";

const home = await startHost();

async function lesson(page: Page, prose: string, asked = `problem="corridor"`): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en"><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <script type="module" src="../mo-copp-playground.js"></script>
      <form>${prose}</form><mo-copp-playground id="one" ${asked} link="off"></mo-copp-playground>`,
  });
  await page.goto(`${home.address}lesson/page.html`);
  await stepIs(page, 5);
}

const stepIs = (page: Page, step: number) => page.waitForSelector(`#one[data-status=optimal][data-step="${step}"]`);
const field = (id: string, name: string, kind = `type="text"`) =>
  `<input id="${id}" aria-label="${id}" ${kind} data-mo-copp-for="one" data-mo-copp-show="${name}">`;
const said = async (page: Page) => (await page.locator("#one").getByRole("alert").first().textContent())?.trim();

test("a field that holds what can't be used says so itself, and the playground stays as it is", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `${field("text", "step")}<textarea id="area" data-mo-copp-for="one" data-mo-copp-show="step"></textarea>
       ${field("number", "step", `type="number"`)}${field("k", "k")}${field("horizon", "horizon")}`,
    );
    const states = (id: string) =>
      page.locator(`#${id}`).evaluate((node) => {
        const { validationMessage, validity, value } = node as HTMLInputElement;
        return [validity.valid, node.getAttribute("aria-invalid"), validationMessage !== "", value];
      });
    const wrong: [id: string, typed: string[], shown: string, words: RegExp][] = [
      ["text", ["-5", "abc", "1.5", "2x"], "5", /^“.+” can’t be used here; expected a whole number from 0\.$/],
      ["area", ["-5", "abc"], "5", /^“.+” can’t be used here; expected a whole number from 0\.$/],
      ["number", ["-5", "1.5"], "5", /./],
      ["k", ["-5", "abc"], "", /^“.+” can’t be used here; expected a whole number\.$/],
      ["horizon", ["-5", "each"], "", /^“.+” can’t be used here; expected a whole number, or any\.$/],
    ];
    for (const [id, texts, shown, words] of wrong) {
      for (const typed of texts) {
        await page.locator(`#${id}`).fill(typed);
        assert.deepEqual(await states(id), [false, "true", true, typed], `${id}: ${typed}`);
        const message = await page.locator(`#${id}`).evaluate((node) => (node as HTMLInputElement).validationMessage);
        assert.match(message, words);
        assert.equal(
          await page.locator("body > form").evaluate((form) => (form as HTMLFormElement).checkValidity()),
          false,
        );
        assert.equal(await page.locator("#one").getAttribute("data-step"), "5", `${id}: ${typed}`);
        assert.equal(await said(page), "", "the playground says nothing");
        // What is left gives way to what is there.
        await page.locator(`#${id}`).blur();
        if (shown !== "") assert.deepEqual(await states(id), [true, null, false, shown], `${id} is left`);
        else await page.locator(`#${id}`).fill("");
        assert.deepEqual((await states(id)).slice(0, 3), [true, null, false], `${id} is mended`);
      }
    }
    await page.locator("#text").fill("abc");
    await page.locator("#text").fill("3");
    await stepIs(page, 3);
    assert.deepEqual(await states("text"), [true, null, false, "3"]);
    // What the page itself finds wrong with a field stays, and is not set.
    await page.locator("#area").evaluate((area) => (area as HTMLTextAreaElement).setCustomValidity("Not now."));
    await page.locator("#area").fill("1");
    assert.equal(await page.locator("#one").getAttribute("data-step"), "3");
    assert.equal(
      await page.locator("#area").evaluate((area) => (area as HTMLTextAreaElement).validationMessage),
      "Not now.",
    );
    await page.locator("#k").fill("2");
    await page.waitForSelector("#one[k='2'][data-status=optimal]");
    await page.locator("#horizon").fill("any");
    await page.waitForSelector("#one[horizon=any][data-status=optimal]");
    assert.equal(await said(page), "");
  }));

test("a step beyond the last is the last: by attribute, link, field, method and message", () =>
  visit(async ({ page }) => {
    const link = (step: string) =>
      `<button type="button" id="to-${step}" data-mo-copp-for="one" data-mo-copp-set-step="${step}">${step}</button>`;
    await lesson(
      page,
      `${field("text", "step")}${field("number", "step", `type="number"`)}
       <textarea id="area" data-mo-copp-for="one" data-mo-copp-show="step"></textarea>${link("99")}${link("12345678")}`,
      `problem="corridor" step="99"`,
    );
    const one = page.locator("#one");
    const ways: Record<string, () => Promise<unknown>> = {
      "the attribute": () => one.evaluate((node) => node.setAttribute("step", "1000")),
      "the attribute, and far beyond": () => one.evaluate((node) => node.setAttribute("step", "9".repeat(400))),
      "the property": () => one.evaluate((node) => Object.assign(node, { step: 6 })),
      "a method": () => one.evaluate((node) => (node as MoCoppPlayground).goTo(10_000_000)),
      "a link": () => page.locator("#to-99").click(),
      "a link far beyond": () => page.locator("#to-12345678").click(),
      "a text field": () => page.locator("#text").fill("99"),
      "a number": () => page.locator("#number").fill("999"),
      "an area": () => page.locator("#area").fill("12345678"),
    };
    for (const [name, act] of Object.entries(ways)) {
      await one.evaluate((node) => (node as MoCoppPlayground).goTo(2));
      await stepIs(page, 2);
      await act();
      await stepIs(page, 5);
      assert.equal(await said(page), "", name);
      for (const id of ["text", "number", "area"]) assert.equal(await page.locator(`#${id}`).inputValue(), "5", name);
    }
    // Where the last is shown already, a field says that, too, once it is left.
    for (const id of ["text", "number", "area"]) {
      await page.locator(`#${id}`).fill("99");
      await page.locator(`#${id}`).blur();
      assert.equal(await page.locator(`#${id}`).inputValue(), "5", id);
    }
    // A picture is of the step that was asked for, or of none.
    const refused = await one.evaluate((node) => (node as MoCoppPlayground).toSVG({ step: 6 }).catch(String));
    assert.match(String(refused), /step: found 6, expected a whole number from 0 to 5$/);
    // A frame hears the same.
    home.own.set("lesson/frame.html", {
      body: `<!doctype html><html lang="en"><link rel="icon" href="data:,"><title>Lesson</title>
        <iframe src="../index.html?problem=corridor&amp;step=99&amp;hide=intro,footer" title="One"></iframe>`,
    });
    await page.goto(`${home.address}lesson/frame.html`);
    const inner = page.frameLocator("iframe").locator("mo-copp-playground");
    const shown = (step: number) =>
      page
        .frameLocator("iframe")
        .locator(`mo-copp-playground[data-status=optimal][data-step="${step}"]`)
        .waitFor({ state: "attached" });
    await shown(5);
    await inner.evaluate((node) => (node as MoCoppPlayground).goTo(1));
    await shown(1);
    await page.evaluate(() =>
      document
        .querySelector("iframe")
        ?.contentWindow?.postMessage({ type: "mo-copp", version: 1, command: "step", step: 99 }, "*"),
    );
    await shown(5);
  }));

test("after a reset of their form, fields show what is so, as before it", () =>
  visit(async ({ page }) => {
    const select = (id: string, name: string, values: string[]) =>
      `<select id="${id}" data-mo-copp-for="one" data-mo-copp-show="${name}">${values.map((value) => `<option>${value}</option>`).join("")}</select>`;
    await lesson(
      page,
      `${select("solver", "solver", ["ip", "exact", "legible"])}${select("theme", "theme", ["dark", "light", "auto"])}
       ${select("problem", "problem", ["delivery", "corridor"])}${field("number", "step", `type="number"`)}
       ${field("range", "step", `type="range"`)}${field("dark", "theme", `type="checkbox" value="dark"`)}
       <input type="radio" name="r" id="light" value="light" data-mo-copp-for="one" data-mo-copp-show="theme">
       <button type="reset">Start again</button>`,
    );
    const values = () =>
      page.evaluate(() =>
        [...document.querySelectorAll<HTMLInputElement>("form :is(input, select)")].map(
          ({ id, type, value, checked }) =>
            type === "radio" || type === "checkbox" ? `${id} ${checked}` : `${id} ${value}`,
        ),
      );
    await page.locator("#solver").selectOption("legible");
    await page.waitForSelector("#one[data-status=solved]");
    await page.locator("#theme").selectOption("dark");
    await page.locator("#number").fill("1");
    await page.waitForSelector(`#one[data-step="1"]`);
    const before = [
      "solver legible",
      "theme dark",
      "problem corridor",
      "number 1",
      "range 1",
      "dark true",
      "light false",
    ];
    assert.deepEqual(await values(), before);
    await page.getByRole("button", { name: "Start again" }).click();
    await page.waitForTimeout(100);
    assert.deepEqual(await values(), before, "by the button");
    await page.evaluate(() => document.querySelector("form")?.reset());
    await page.waitForTimeout(100);
    assert.deepEqual(await values(), before, "by a script");
  }));

test("fields for the solver show the one that is at work, also where no attribute names it", () =>
  visit(async ({ page }) => {
    const radio = (value: string) =>
      `<input type="radio" name="r" id="${value}" value="${value}" data-mo-copp-for="one" data-mo-copp-show="solver">`;
    await lesson(
      page,
      `<select id="list" data-mo-copp-for="one" data-mo-copp-show="solver"><option>ip<option>exact<option>legible</select>
       ${radio("exact")}${radio("ip")}`,
    );
    const shown = async () => [
      await page.locator("#list").inputValue(),
      await page.locator("#exact").isChecked(),
      await page.locator("#ip").isChecked(),
    ];
    assert.deepEqual(await shown(), ["exact", true, false]);
    await page.locator("#list").selectOption("legible");
    await page.waitForSelector("#one[data-status=solved]");
    assert.deepEqual(await shown(), ["legible", false, false]);
    // A script has another one solve.
    await page.locator("#one").evaluate((one) => (one as MoCoppPlayground).solve({ solver: "ip" }));
    await page.waitForFunction(() => document.querySelector<HTMLSelectElement>("#list")?.value === "ip");
    assert.deepEqual(await shown(), ["ip", false, true]);
    await page.locator("#list").selectOption("legible");
    await page.waitForSelector("#one[data-status=solved]");
    assert.deepEqual(await shown(), ["legible", false, false]);
    await page.locator("#one").evaluate((one) => one.removeAttribute("solver"));
    await page.waitForSelector("#one[data-status=optimal]");
    assert.deepEqual(await shown(), ["exact", true, false]);
  }));
