// The element as a field of a form: what other fields have, a required answer, and a fieldset that is disabled.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { exerciseText, give } from "./support/exercises.js";
import { startHost } from "./support/host.js";
import { press } from "./support/playground.js";

test("the element has what fields have, and a required answer is missing until one is checked", async () => {
  const host = await startHost();
  host.own.set("favicon.ico", { body: "" });
  host.own.set("goals.json", { body: exerciseText("01-possible-goals") });
  host.own.set("page.html", {
    body: `<!doctype html><html lang="en"><title>Course</title><script type="module" src="mo-copp-playground.js"></script>
      <main><form id="course"><fieldset><mo-copp-playground src="goals.json" seed="7" link="off" name="q" required></mo-copp-playground></fieldset>
      <button>Hand in</button></form></main>`,
  });
  await visit(async ({ page }) => {
    await page.goto(`${host.address}page.html`);
    await page.locator(".choices input").first().waitFor();
    const element = page.locator("mo-copp-playground");
    const field = () =>
      element.evaluate((node) => {
        const { form, value, name, type, required, disabled, willValidate, validity, validationMessage } =
          node as MoCoppPlayground & { name: string; required: boolean; disabled: boolean };
        const missing = validity?.valueMissing;
        return { form: form?.id, value, name, type, required, disabled, willValidate, missing, validationMessage };
      });
    const message = "Check an answer to this question first: its code is what the form sends.";
    const empty = { form: "course", value: "", name: "q", type: "mo-copp-playground", required: true, disabled: false };
    assert.deepEqual(await field(), { ...empty, willValidate: true, missing: true, validationMessage: message });
    const valid = () =>
      element.evaluate((node) => {
        const playground = node as MoCoppPlayground;
        return [playground.checkValidity(), playground.reportValidity(), playground.form?.checkValidity()];
      });
    assert.deepEqual(await valid(), [false, false, false]);
    // What is missing is shown at the button that checks an answer.
    const focused = () => element.evaluate((node) => node.shadowRoot?.activeElement?.textContent?.trim());
    assert.equal(await focused(), "Check the answer");
    // A fieldset that is disabled takes all controls with it; a disabled field is not looked at.
    const fieldset = (disabled: boolean) =>
      page.evaluate((disabled) => {
        const fieldset = document.querySelector("fieldset");
        if (fieldset !== null) fieldset.disabled = disabled;
      }, disabled);
    const controls = () =>
      element.evaluate((node) =>
        [...(node.shadowRoot?.querySelectorAll(".exercise :is(button, input)") ?? [])].map((one) =>
          one.matches(":disabled"),
        ),
      );
    await fieldset(true);
    await page.locator(".exercise .whole:disabled").waitFor();
    assert.deepEqual(new Set(await controls()), new Set([true]));
    assert.equal((await field()).willValidate, false);
    await fieldset(false);
    await page.locator(".exercise .whole:enabled").waitFor();
    assert.deepEqual(new Set(await controls()), new Set([false]));
    await page.locator(".choices input").first().check();
    await press(page, "Check the answer");
    await page.getByText("2 attempts left.").waitFor();
    const { value, missing, validationMessage } = await field();
    assert.equal(value, await page.getByLabel("Answer code").inputValue());
    assert.deepEqual([missing, validationMessage], [false, ""]);
    assert.deepEqual(await valid(), [true, true, true]);
    await page.evaluate(() => document.querySelector("form")?.reset());
    assert.deepEqual(await valid(), [false, false, false]);
    await element.evaluate((node) => Object.assign(node, { required: false }));
    assert.deepEqual(await valid(), [true, true, true]);
    // The attribute disables as well.
    await element.evaluate((node) => Object.assign(node, { disabled: true }));
    await page.locator(".exercise .whole:disabled").waitFor();
  });
});

test("disabled is on by being there, and “false”, as frameworks write it, takes it away", async () => {
  const host = await startHost();
  host.own.set("favicon.ico", { body: "" });
  host.own.set("goals.json", { body: exerciseText("01-possible-goals") });
  const field = (id: string, disabled: string) =>
    `<mo-copp-playground id="${id}" src="goals.json" seed="7" link="off" name="${id}" ${disabled}></mo-copp-playground>`;
  host.own.set("page.html", {
    body: `<!doctype html><html lang="en"><title>Course</title><script type="module" src="mo-copp-playground.js"></script>
      <main><form>${field("no", 'disabled="false"')}${field("yes", "disabled")}${field("true", 'disabled="true"')}
      <fieldset disabled>${field("inside", 'disabled="false"')}</fieldset></form></main>`,
  });
  await visit(async ({ page }) => {
    await page.goto(`${host.address}page.html`);
    await page.locator("#inside .choices input").first().waitFor();
    await page.locator("#no .choices input").first().waitFor();
    const state = (id: string) =>
      page.locator(`#${id}`).evaluate((node) => {
        const { disabled, willValidate, shadowRoot } = node as MoCoppPlayground & { disabled: boolean };
        const controls = shadowRoot?.querySelector(".exercise .whole")?.matches(":disabled");
        return { disabled, native: node.matches(":disabled"), willValidate, controls };
      });
    const on = { disabled: true, native: true, willValidate: false, controls: true };
    const off = { disabled: false, native: false, willValidate: true, controls: false };
    assert.deepEqual(await state("no"), off, "false");
    assert.deepEqual(await state("yes"), on, "without a value");
    assert.deepEqual(await state("true"), on, "true");
    assert.deepEqual(await state("inside"), { ...on, disabled: false }, "of a field set that is disabled");
    const set = (value: string | null) =>
      page.locator("#no").evaluate((node, value) => {
        if (value === null) node.removeAttribute("disabled");
        else node.setAttribute("disabled", value);
      }, value);
    const steps: [value: string | null, state: object][] = [
      ...[["", on] as [string, object], ["false", off] as [string, object], ["disabled", on] as [string, object]],
      [null, off],
    ];
    for (const [value, expected] of steps) {
      await set(value);
      await page.locator(`#no .exercise .whole${expected === on ? ":disabled" : ":enabled"}`).waitFor();
      assert.deepEqual(await state("no"), expected, String(value));
    }
  });
});

test("the page hears input and change when the person changes the answer code, and nothing of the controls inside", async () => {
  const host = await startHost();
  host.own.set("favicon.ico", { body: "" });
  host.own.set("goals.json", { body: exerciseText("01-possible-goals") });
  host.own.set("page.html", {
    body: `<!doctype html><html lang="en"><title>Course</title><script type="module" src="mo-copp-playground.js"></script>
      <script>
        window.heard = [];
        for (const type of ["input", "change", "beforeinput"])
          addEventListener(type, (event) => heard.push([type, event.target.id, event.target.value ?? ""]));
      </script>
      <main><form><mo-copp-playground id="question" src="goals.json" seed="7" link="off" name="q"></mo-copp-playground></form>
      <mo-copp-playground id="lab" problem="corridor" link="off"><input id="own"></mo-copp-playground></main>`,
  });
  await visit(async ({ page }) => {
    await page.goto(`${host.address}page.html`);
    await page.locator("#lab:is([data-status=optimal], [data-status=solved])").waitFor();
    const heard = () => page.evaluate(() => (window as unknown as { heard: string[][] }).heard.splice(0));
    // Steps, options and texts are controls of the playground.
    await page.locator("#lab input[type=range]").first().fill("2");
    await page.locator("#lab[data-step='2']").waitFor();
    await page.locator("#lab").getByRole("tab", { name: "Document" }).click();
    await page.locator("#lab .cm-content").click();
    await page.keyboard.type(" ");
    await page.locator("#question .choices input").first().check();
    assert.deepEqual(await heard(), []);
    // A child of the element is the page's own.
    await page
      .locator("#own")
      .evaluate((own) => own.dispatchEvent(new InputEvent("input", { bubbles: true, composed: true })));
    assert.deepEqual(await heard(), [["input", "own", ""]]);
    const question = page.locator("#question");
    await question.getByRole("button", { name: "Check the answer" }).click();
    await question.getByText("2 attempts left.").waitFor();
    const code = await question.getByLabel("Answer code").inputValue();
    assert.deepEqual(await heard(), [
      ["input", "question", code],
      ["change", "question", code],
    ]);
    // What the page does is no change for it: a reset, and a state that is set.
    const state = await question.evaluate((node) => (node as MoCoppPlayground).state);
    await page.evaluate(() => document.querySelector("form")?.reset());
    await question.evaluate((node) => Object.assign(node, { problem: "corridor" }));
    await question.locator("[data-board]").first().waitFor();
    await page.waitForFunction(() => document.querySelector<MoCoppPlayground>("#question")?.value === "");
    await question.evaluate((node, state) => Object.assign(node, { state }), state);
    await page.waitForFunction(() => document.querySelector<MoCoppPlayground>("#question")?.value !== "");
    assert.equal(await question.getByLabel("Answer code").inputValue(), code);
    assert.deepEqual(await heard(), []);
  });
});

test("while a question is shown, no script solves, draws or walks through the problem that was open before", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    const { vary: _, ...exercise } = JSON.parse(exerciseText("12-best")).exercise;
    await give(
      page,
      JSON.stringify({ ...JSON.parse(exerciseText("12-best")), exercise: { ...exercise, lock: ["walls"] } }),
    );
    await page.locator("#exercise-question").waitFor();
    const refusals = () =>
      page.locator("mo-copp-playground").evaluate(async (node) => {
        const playground = node as MoCoppPlayground;
        const asked = [
          () => playground.solve({ solver: "exact" }),
          () => playground.toSVG(),
          () => playground.toPNG(),
          () => playground.goTo(0),
        ];
        const refused: string[] = [];
        for (const ask of asked)
          refused.push(
            await ask().then(
              () => "done",
              (error: Error) => error.message,
            ),
          );
        return refused;
      });
    for (const refused of await refusals()) assert.match(refused, /^A question is shown, without steps, solvers/);
    await press(page, "Open the problem in the playground");
    await page.getByText("Locked in it: walls.").waitFor();
    assert.match((await refusals())[0] ?? "", /^The solvers are closed until the question/);
    await press(page, "Back to the question");
    await page.locator("#exercise-question").waitFor();
    for (const refused of await refusals()) assert.match(refused, /^A question is shown, without steps, solvers/);
  }));
