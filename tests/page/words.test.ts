// Sentences that must be true: what a solver's answer leaves open, what can't be used, where a fault stands.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { templates } from "../../www/src/text/templates.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { attribute, choose, openTab, press, statusIs } from "./support/playground.js";
import { address } from "./support/site.js";
import { field, linesOf, put, said } from "./support/text.js";

const alert = (page: Page) => page.getByRole("alert").first();
const open = (page: Page, search: string) => page.goto(`${address}?${search}`);

test("of a plan that reaches the most there is, no better one is said to be possible", () =>
  visit(async ({ page }) => {
    await open(page, "problem=delivery");
    await statusIs(page, "optimal");
    await choose(page, "Solver", "search");
    await press(page, "Solve");
    await statusIs(page, "solved");
    assert.equal(await attribute(page, "data-gd"), "1");
    await page.getByText("Goal difference 1 in 3 moves. No plan has a larger one.").waitFor();
    assert.equal(await page.getByText("better plan may exist").count(), 0);
    // A plan as good as the best that is proved, where that is less than 1.
    await open(page, "problem=eight-by-eight&horizon=20");
    await statusIs(page, "optimal");
    await choose(page, "Solver", "baseline");
    await press(page, "Solve");
    await statusIs(page, "solved");
    const best = await page.locator(".difference .best").textContent();
    const own = await attribute(page, "data-gd");
    const words =
      own !== null && best?.includes(`: ${own}`) ? "That is the best possible." : "It looks for no better plan.";
    await page.getByText(own === "1" ? "No plan has a larger one." : words).waitFor();
  }));

test("a number that is too large is not called no number", () =>
  visit(async ({ page }) => {
    for (const [search, words] of [
      ["horizon=99999999", "The plan length must be at most 10,000; found “99999999”."],
      ["k=123456789", "“123456789” can’t be used for the attribute k; expected a whole number from 1 to"],
      [
        "k=1234567890123456789",
        "“1234567890123456789” can’t be used for the attribute k; expected a whole number from 1",
      ],
      ["j=9999999999999999", "“9999999999999999” can’t be used for the attribute j; expected a whole number from 1"],
      ["horizon=soon", "The plan length must be a whole number; found “soon”."],
    ] as const) {
      await open(page, search);
      await statusIs(page, "error");
      await alert(page).getByText(words).waitFor();
    }
  }));

test("a plan that is no title and has no steps is said with both that could stand there", () =>
  visit(async ({ page }) => {
    await open(page, "problem=corridor&plan=No such title");
    const set = (attributes: Record<string, string>) =>
      page.locator("mo-copp-playground").evaluate((one, attributes) => void Object.assign(one, attributes), attributes);
    const expected = "expected the title of a plan (“Straight there”, “Past and back”) or actions separated by commas.";
    for (const [plan, words] of [
      ["No such title", 'step 1: found "No such title", expected an action of this problem: north, south'],
      ["east,nope", 'step 2: found "nope", expected an action of this problem: north, south'],
    ] as const) {
      await set({ plan });
      await alert(page)
        .getByText(`“${plan}” can’t be used for the attribute plan; ${expected} As actions: ${words}`)
        .waitFor();
    }
    for (const plan of ["Past and back", "east"]) {
      await set({ plan });
      await alert(page).getByText("can’t be used").waitFor({ state: "detached" });
    }
    // A document has no titles.
    await page.route("**/problem.json", (route) => route.fulfill({ json: JSON.parse(grid()) }));
    await set({ src: "problem.json", plan: "nope" });
    await alert(page)
      .getByText("“nope” can’t be used for the attribute plan; expected actions separated by commas.")
      .waitFor();
  }));

test("an empty plan is the plan without actions", () =>
  visit(async ({ page }) => {
    await open(page, "problem=delivery&plan=");
    await page.getByText("On the boards: The plan of this page").waitFor();
    assert.equal(await attribute(page, "data-step"), "0");
    assert.equal(await page.getByRole("slider").getAttribute("max"), "0");
    assert.equal(await page.locator(".error p").count(), 0);
  }));

test("a solver that can't be started is said to be that, and is tried again by one click", () =>
  visit(
    async ({ page }) => {
      // The first problem comes with its answer; any other takes a solver.
      await open(page, "problem=corridor");
      await statusIs(page, "error");
      const words = (await alert(page).textContent()) ?? "";
      assert.match(
        words,
        /^The solver could not be started: http\S+\.wasm could not be loaded\. Check the connection, then try again\./,
      );
      assert.equal(/your problem|is ready/i.test(words), false);
      await page.getByText("There is nothing to show.").waitFor();
      // It is still so.
      await press(page, "Try again");
      await statusIs(page, "error");
      await page.unroute("**/*.wasm");
      await press(page, "Try again");
      await statusIs(page, "optimal");
      await page.locator('svg[data-board="actor"]').waitFor();
      assert.equal(await page.getByRole("button", { name: "Try again" }).count(), 0);
    },
    { before: (page) => page.route("**/*.wasm", (route) => route.abort()), quiet: false },
  ));

const dropped = async (page: Page, name: string, text: string) => {
  const data = await page.evaluateHandle(
    ([name = "", text = ""]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], name, { type: "application/json" }));
      return transfer;
    },
    [name, text],
  );
  await page.dispatchEvent("main", "drop", { dataTransfer: data });
};

test("a dropped file with a fault is named, quoted, and opened in the editor at the fault", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const text = grid({ start: [9, 9] }).replace('"start"', '\n"start"');
    await dropped(page, "boxes.json", text);
    await alert(page).getByText("“boxes.json”, line 2, column 9, start: found").waitFor();
    await alert(page).getByText('the line reads: "start":').waitFor();
    await field(page).waitFor();
    await page.waitForFunction(
      () =>
        document.activeElement?.shadowRoot?.querySelector(".cm-fault") !== null &&
        document.activeElement?.matches(".text-field"),
    );
    assert((await linesOf(page)).some((line) => line.startsWith("[start: found")));
    // What somebody is typing is not lost by another file.
    await put(page, "{");
    await dropped(page, "other.json", "[");
    await alert(page).getByText("“other.json”, line 1").waitFor();
    assert.deepEqual(
      (await linesOf(page)).filter((line) => !line.startsWith("[")),
      ["{"],
    );
  }));

test("a fault in PDDL has the line and column of the text that is shown", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Document");
    const lamps = templates.find(({ title }) => title === "PDDL")?.text ?? assert.fail();
    const text = lamps.replace("(:types", "(:kinds");
    await put(page, text);
    const line = text.slice(0, text.indexOf(":kinds")).split("\n").length;
    const column = text.indexOf(":kinds") - text.lastIndexOf("\n", text.indexOf(":kinds"));
    await said(page, `domain, line ${line}, column ${column}: found`).waitFor();
    await press(page, "Use this problem");
    await statusIs(page, "error");
    await alert(page).getByText(`domain, line ${line}, column ${column}: found`).waitFor();
    // As PDDL it is the domain's own text that is shown.
    await press(page, "PDDL");
    await said(page, "domain, line 4, column 4: found").waitFor();
    await press(page, "Use this problem");
    await alert(page).getByText("domain, line 4, column 4: found").waitFor();
  }));
