// What a page's script gives a playground by properties, with other things that it sets meanwhile, and what can't be used.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { startHost } from "./support/host.js";

const home = await startHost();

async function lesson(page: Page, asked = `problem="corridor"`): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en"><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <script type="module" src="../mo-copp-playground.js"></script>
      <mo-copp-playground id="one" ${asked} link="off"></mo-copp-playground>`,
  });
  await page.goto(`${home.address}lesson/page.html`);
}

const ready = (page: Page, more = "") => page.waitForSelector(`#one[data-status=optimal]${more}`);
const cells = (page: Page, count: number) =>
  page.waitForFunction(
    (count) =>
      document.querySelector("#one")?.shadowRoot?.querySelectorAll("[data-board=actor] [data-cell]").length === count,
    count,
  );
/** Sets properties and attributes (names that begin with @) in their order and in one turn; `ready` waits for what was set. */
const give = (page: Page, given: readonly (readonly [name: string, value: unknown])[]) =>
  page.evaluate(async (given) => {
    const playground = document.querySelector("#one") as MoCoppPlayground;
    for (const [name, value] of given) {
      if (name.startsWith("@")) playground.setAttribute(name.slice(1), String(value));
      else Reflect.set(playground, name, value);
    }
    // A method waits for whatever was set before it.
    await playground.toSVG();
    await new Promise(requestAnimationFrame);
    return [playground.dataset.step, playground.state?.plan?.join()];
  }, given);

test("a step and a plan that are set with a document, or while it comes, are of that document", () =>
  visit(async ({ page }) => {
    await lesson(page);
    await ready(page, '[data-step="5"]');
    const state = { document: grid({ width: 7 }) };
    assert.deepEqual(
      (
        await give(page, [
          ["document", grid()],
          ["step", 1],
        ])
      )[0],
      "1",
      "document, then step",
    );
    await cells(page, 12);
    assert.deepEqual(
      (
        await give(page, [
          ["step", 2],
          ["document", grid({ width: 5 })],
        ])
      )[0],
      "2",
      "step, then document",
    );
    await cells(page, 15);
    assert.deepEqual(
      (
        await give(page, [
          ["document", grid({ width: 6 })],
          ["@step", 1],
        ])
      )[0],
      "1",
      "an attribute",
    );
    await cells(page, 18);
    assert.deepEqual(
      (
        await give(page, [
          ["state", state],
          ["step", 3],
        ])
      )[0],
      "3",
      "state, then step",
    );
    await cells(page, 21);
    const plan = ["north", "north", "east"];
    assert.deepEqual(
      await give(page, [
        ["document", grid({ width: 5 })],
        ["plan", plan],
        ["step", 2],
      ]),
      ["2", plan.join()],
      "document, then plan and step",
    );
    await cells(page, 15);
    // The document stays the one that was given, whatever is set after it.
    assert.deepEqual(
      await give(page, [
        ["plan", ["north"]],
        ["step", 1],
      ]),
      ["1", "north"],
      "plan and step alone",
    );
    await cells(page, 15);
    // A step of long ago is none of the next document's.
    assert.deepEqual((await give(page, [["document", grid()]]))[0], "5", "a document alone");
    await cells(page, 12);
    // One that can't be opened leaves the one before, also for the attributes that are set with it and after it.
    await give(page, [
      ["document", grid({ width: 0 })],
      ["step", 1],
    ]);
    await page.waitForSelector("#one[data-status=error]");
    await give(page, [
      ["document", grid({ width: 0 })],
      ["plan", plan],
    ]);
    await page.waitForSelector("#one[data-status=error]");
    assert.deepEqual(
      await give(page, [
        ["plan", ["north", "north"]],
        ["step", 2],
      ]),
      ["2", "north,north"],
      "as it was",
    );
    await cells(page, 12);
  }));

test("a state that was set before the first picture takes the step that it does not name from the element", () =>
  visit(async ({ page }) => {
    await lesson(page, `problem="corridor" step="2" loading="lazy" style="margin-top: 5000px"`);
    await page.waitForSelector("#one[data-status=idle]");
    assert.equal((await give(page, [["state", { document: grid() }]]))[0], "2", "the step of the element");
    await lesson(page, `problem="corridor" step="2" loading="lazy" style="margin-top: 5000px"`);
    await page.waitForSelector("#one[data-status=idle]");
    assert.equal((await give(page, [["state", { document: grid(), step: 1 }]]))[0], "1", "its own step");
  }));

test("a value that no JSON can be made of is said, before there is a picture and after", () =>
  visit(async ({ page }) => {
    const values = [
      "() => 1",
      "Symbol('x')",
      "1n",
      "(() => { const a = {}; a.a = a; return a; })()",
      "({ width: 3n })",
    ];
    const found = ["A function", "A symbol", "A BigInt", "An object that is no JSON", "An object that is no JSON"];
    const expected = { document: "a problem document, as an object or as its text", state: "what state has held" };
    const set = (name: string, value: string) =>
      page.evaluate(`void (document.querySelector("#one").${name} = ${value})`);
    const told = (text: string) => page.locator("#one").getByRole("alert").first().getByText(text).waitFor();
    await lesson(page);
    await ready(page);
    for (const [name, words] of Object.entries(expected)) {
      for (const [at, value] of values.entries()) {
        await set(name, value);
        await told(`${found[at]}`);
        await told(`can’t be used for the property ${name}; expected ${words}`);
        assert.equal(await page.locator("#one").getAttribute("data-step"), "5", "what was shown stays");
        await page.locator("#one").getByRole("button", { name: "Close the message" }).click();
        await ready(page);
      }
    }
    for (const value of ["5", "true", "[]"]) {
      await set("document", value);
      await page.waitForSelector("#one[data-status=error]");
      const text = (await page.locator("#one").getByRole("alert").first().textContent()) ?? "";
      assert.match(text, /^document: found .+, expected an object/);
      await page.locator("#one").getByRole("button", { name: "Close the message" }).click();
      await ready(page);
    }
    await lesson(page, `problem="corridor" loading="lazy" style="display: block; margin-top: 5000px"`);
    await page.waitForSelector("#one[data-status=idle]");
    await set("document", "() => 1");
    await page.locator("#one").scrollIntoViewIfNeeded();
    await told("A function can’t be used for the property document");
    assert.equal(await page.locator("#one .title", { hasText: "One step too far" }).count(), 1, "there is a picture");
  }));

test("document and state as attributes are said, and an attribute that says “false” is not there", () =>
  visit(async ({ page }) => {
    await lesson(page, `problem="corridor" document="[object Object]" state="" watch="false"`);
    const alert = page.locator("#one").getByRole("alert").first();
    await alert
      .getByText(
        "“document” is no attribute but a property: it is set by a script (element.document = …), or stands in",
      )
      .waitFor();
    await alert
      .getByText("“state” is no attribute but a property: it is set by a script (element.state = …).")
      .waitFor();
    assert.equal(await page.locator("#one").getAttribute("data-step"), "5", "nobody is invited to watch");
    assert.equal(
      await page.locator("#one").evaluate((one) => (one as MoCoppPlayground & { watch: boolean }).watch),
      false,
    );
    await page.locator("#one").evaluate((one) => {
      one.removeAttribute("document");
      one.removeAttribute("state");
    });
    await ready(page);
    await page.locator("#one").evaluate((one) => one.setAttribute("document", "{}"));
    await alert.getByText("“document” is no attribute").waitFor();
    await lesson(page, `problem="corridor" watch="false"`);
    await ready(page, '[data-step="5"]');
    assert.equal((await alert.textContent())?.trim(), "");
    await lesson(page, `problem="corridor" hide="enemy friend"`);
    await ready(page, '[data-step="5"]');
    const boards = await page
      .locator("#one svg[data-board]")
      .evaluateAll((boards) => boards.map((board) => (board as SVGElement).dataset.board));
    assert.deepEqual(boards, ["actor"], "the agent's board stands alone");
    assert.equal((await alert.textContent())?.trim(), "");
    await lesson(page, `problem="corridor" watch`);
    await ready(page, '[data-step="0"]');
  }));

test("a plan, a step or a bound that is set while a state is on its way, or after, leaves the state’s other options", () =>
  visit(async ({ page }) => {
    const form = { solver: "search", k: "1", j: "2" };
    const state = { document: grid({ width: 6 }), form, answered: true, step: 1 };
    const plan = ["north", "north", "east"];
    const told = async () => {
      const { form, plan, step } = await page
        .locator("#one")
        .evaluate((one) => (one as MoCoppPlayground).state as NonNullable<MoCoppPlayground["state"]>);
      return { form, plan, step };
    };
    // Attributes of long ago are not the state's.
    const begin = () => lesson(page, `problem="corridor" k="2" step="3" solver="exact"`).then(() => ready(page));
    await begin();
    await give(page, [["state", state]]);
    const { plan: own, ...alone } = await told();
    assert.deepEqual(alone, { form, step: 1 }, "a state alone");
    for (const [name, given] of Object.entries({
      "the property": [
        ["state", state],
        ["plan", plan],
      ],
      "the attribute": [
        ["state", state],
        ["@plan", plan.join()],
      ],
      "before the state": [
        ["plan", plan],
        ["state", state],
      ],
    } as const)) {
      await begin();
      await give(page, given);
      assert.deepEqual(await told(), { form, plan, step: 3 }, name);
    }
    await cells(page, 18);
    await begin();
    await give(page, [
      ["state", state],
      ["plan", plan],
      ["step", 2],
    ]);
    assert.deepEqual(await told(), { form, plan, step: 2 }, "a plan and a step");
    // In turns of their own.
    await begin();
    await give(page, [["state", state]]);
    await give(page, [["plan", plan]]);
    assert.deepEqual(await told(), { form, plan, step: 3 }, "a plan once the state is there");
    await give(page, [["horizon", 9]]);
    assert.deepEqual((await told()).form, { ...form, horizon: "9" }, "a bound");
    await give(page, [["document", grid()]]);
    await give(page, [["plan", ["north"]]]);
    assert.deepEqual((await told()).plan, ["north"], "another document");
    await cells(page, 12);
    assert(own !== undefined && own.length > 0, "the solver has found a plan");
  }));
