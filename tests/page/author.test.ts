// The tab that makes an exercise of the open problem: tried as a student, as a link, as code.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import type { GridworldDocument } from "../../www/src/problem/types.js";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { startHost } from "./support/host.js";
import { opened } from "./support/opened.js";
import { openTab, press, slider, statusIs, stepIs, useDocument } from "./support/playground.js";
import { address } from "./support/site.js";

test("an exercise is made of the steps shown, tried, and edited again", () =>
  opened({ document: grid(), tab: "Exercise" }, async (page) => {
    await page.getByLabel("Title").fill("Mine");
    await page.getByLabel("Hints, one a line").fill("One\nTwo");
    await page.getByLabel("Attempts (empty: any number)").fill("2");
    await assertNoBarrier(page, "the form of an exercise");
    await slider(page).fill("2");
    await page.getByText("about the 2 steps").waitFor();
    await press(page, "Try it as a student");
    await page.getByRole("heading", { name: "Mine" }).waitFor();
    await page.getByText("2 attempts left.").waitFor();
    await page.getByRole("button", { name: "Show a hint (2 left)" }).waitFor();
    assert.equal(await page.locator(".exercise").getAttribute("data-kind"), "possible-goals");
    await press(page, "Back to editing");
    await page.locator("[data-board=actor]").waitFor();
    assert.equal(await page.getByLabel("Title").inputValue(), "Mine");
    // The same question still: the step that it is about is shown again.
    await page.getByText("about the 2 steps").waitFor();
  }));

test("what is tried is not in the address: a reload leads back to the editing", () =>
  opened({ document: grid(), tab: "Exercise" }, async (page) => {
    await page.getByLabel("Kind of question").selectOption("best");
    await page.getByLabel("Title").fill("Mine");
    await press(page, "Try it as a student");
    await page.getByText("This question is trivial").waitFor();
    await press(page, "Try it as a student");
    await page.getByRole("heading", { name: "Mine" }).waitFor();
    await page.waitForFunction(() => location.hash !== "");
    // Longer than the address waits for the next change.
    await page.waitForTimeout(600);
    await page.reload();
    await page.locator("[data-board=actor]").waitFor();
    assert.equal(await page.getByLabel("Title").inputValue(), "Mine");
    assert.equal(await page.locator(".exercise").count(), 0, "no exercise is open");
  }));

test("an exercise that is wrong stays in the form, with the core's word of why", () =>
  opened({ document: grid(), tab: "Exercise" }, async (page) => {
    await page.getByLabel("Attempts (empty: any number)").fill("many");
    await press(page, "Try it as a student");
    await page.getByText('Attempts: "many" can’t be used; it takes a whole number from 1 to 99.').waitFor();
    // Nothing that is wrong is handed out.
    await page.getByLabel("Attempts (empty: any number)").fill("none");
    assert.equal(await page.getByText("Attempts: ").count(), 0);
    await press(page, "Copy a link");
    await page.getByText('Attempts: "none" can’t be used').waitFor();
    assert.equal(await page.getByText("Copied.").count(), 0);
    await page.getByLabel("Attempts (empty: any number)").fill("");
    await page.getByLabel("Kind of question").selectOption("walk");
    await page.getByLabel("Goal difference of at least").fill("half");
    await press(page, "Copy a link");
    await page.getByText('"half" can’t be used; it takes a number from -1 to 1, or a fraction').waitFor();
    // As it was typed, not as the number that it is.
    await page.getByLabel("Goal difference of at least").fill("4/3");
    await press(page, "Copy a link");
    await page.getByText('"4/3" can’t be used; it takes a number from -1 to 1, or a fraction').waitFor();
    assert.equal(await page.getByText("1.33").count(), 0, "no decimals of it");
    await page.getByLabel("Goal difference of at least").fill("-1");
    // What is only trivial is handed out when it is asked for again.
    await press(page, "Try it as a student");
    await page.getByText("This question is trivial: a shortest walk answers it.").waitFor();
    await assertNoBarrier(page, "a warning");
    assert.equal(await page.locator(".exercise").count(), 0);
    await press(page, "Try it as a student");
    await page.locator('.exercise[data-kind="walk"]').waitFor();
  }));

test("what the plan shown leaves no answer to is refused in plain words, and what a format lacks is not offered", () =>
  opened({ tab: "Exercise" }, async (page) => {
    const refused = async (words: string) => {
      await press(page, "Copy code for a page");
      await page.getByRole("alert").getByText(words).waitFor();
    };
    await page.getByLabel("Kind of question").selectOption("guess");
    await page.getByLabel("Whose view").selectOption("adversarial");
    await refused("Nobody can tell the goal: 4 goals fit the symbols.");
    await page.getByLabel("Kind of question").selectOption("walk");
    assert.equal(await page.getByText("Nobody can tell the goal").count(), 0);
    await page.getByLabel("At most so many steps").fill("1");
    await refused("No walk is as good as that: ask for a smaller goal difference or for more steps.");
    await page.getByLabel("At most so many steps").fill("");
    await page.getByLabel("Goal difference of at least").fill("");
    await refused("Say which goal difference the walk must have at least, or how many steps at most.");
    await page.getByLabel("Goal difference of at least").fill("-1");
    await page.getByLabel("the walls").check();
    await refused("A trivial question cannot be other for each student: a shortest walk answers it.");
    await page.goto(`${address}?problem=delivery`);
    await statusIs(page, "optimal");
    await openTab(page, "Exercise");
    assert.equal(await page.getByLabel("Kind of question").locator("[value=placement]").count(), 0);
    for (const lacking of ["the start", "the goals", "the walls"])
      assert.equal(await page.getByLabel(lacking, { exact: true }).count(), 0, lacking);
    assert.equal(await page.getByText("A link asks each student for a name").count(), 0);
    await page.getByLabel("the true goal").check();
    await page.getByText("A link asks each student for a name").waitFor();
  }));

test("variants that no student gets are refused, and such as are all the same are handed out when asked for again", () =>
  opened({ tab: "Exercise" }, async (page) => {
    await page.getByLabel("Kind of question").selectOption("best");
    await page.getByLabel("the true goal").check();
    await press(page, "Try it as a student");
    const same = page.getByText("Of what is other for each student: all 20 variants drawn ask the same question.");
    await same.waitFor();
    assert.equal(await page.locator(".exercise").count(), 0);
    // Of another exercise nothing is said yet.
    await page.getByLabel("the goals").check();
    assert.equal(await same.count(), 0);
    await page.getByLabel("the goals").uncheck();
    await press(page, "Try it as a student");
    await same.waitFor();
    await press(page, "Try it as a student");
    await page.locator('.exercise[data-kind="best"]').waitFor();
    const plan = "north,west,west,west,west,north,south,east,east,east,east,north,north,east,east,east";
    await page.goto(`${address}?problem=head-fake&plan=${plan}&step=${plan.split(",").length}`);
    await stepIs(page, plan.split(",").length);
    await openTab(page, "Exercise");
    await page.getByLabel("Kind of question").selectOption("guess");
    await page.getByLabel("Whose view").selectOption("cooperative");
    await page.getByLabel("the walk").check();
    for (let presses = 0; presses < 2; presses += 1) {
      await press(page, "Try it as a student");
      await page
        .getByText(
          "Some students would get no question: none of 4 seeds drawn has a variant. Let something else be other for each student, or nothing.",
        )
        .waitFor();
      assert.equal(await page.locator(".exercise").count(), 0);
    }
  }));

test("where few problems drawn have a question, it is said what helps", () =>
  opened({ tab: "Exercise" }, async (page) => {
    await page.getByLabel("Kind of question").selectOption("belief");
    for (const name of ["the start", "the walls"]) await page.getByLabel(name).check();
    await press(page, "Try it as a student");
    await page.getByText(/no question: .+ The walk is the same for all, .+: let the walk be other, too\.$/).waitFor();
    await page.getByLabel("the walk").check();
    await press(page, "Try it as a student");
    await page.locator('.exercise[data-kind="belief"]').waitFor();
  }));

test("where a student would choose among many states, it is said once, with what helps", () =>
  opened({ tab: "Exercise" }, async (page) => {
    await page.goto(`${address}?problem=box-pushing`);
    await statusIs(page, "optimal");
    await openTab(page, "Exercise");
    await page.getByLabel("Kind of question").selectOption({ label: "Which states are possible" });
    await press(page, "Try it as a student");
    await page.getByText(/^A student chooses among [\d,]+ states: a smaller problem leaves fewer/).waitFor();
    assert.equal(await page.locator(".exercise").count(), 0);
    await press(page, "Try it as a student");
    await page.locator('.exercise[data-kind="belief"]').waitFor();
    await page.getByRole("searchbox", { name: "Search" }).waitFor();
    await assertNoBarrier(page, "a long list of states");
  }));

test("the link opens the question, and the code holds the document", () =>
  opened({ tab: "Exercise", permissions: ["clipboard-read", "clipboard-write"] }, async (page) => {
    await page.getByLabel("Kind of question").selectOption("best");
    await press(page, "Copy code for a page");
    await page.getByText("Copied.").waitFor();
    const code = await page.evaluate(() => navigator.clipboard.readText());
    const [, document = ""] = /<script type="application\/json">\n([\s\S]*?)\n<\/script>/.exec(code) ?? [];
    assert.deepEqual(JSON.parse(document).exercise, { kind: "best" });
    assert.match(code, /<script type="module" src="mo-copp\/mo-copp-playground.js"><\/script>/);
    await press(page, "Copy a link");
    await page.waitForFunction(async () => (await navigator.clipboard.readText()).startsWith("http"));
    const link = await page.evaluate(() => navigator.clipboard.readText());
    await page.goto("about:blank");
    await page.goto(link);
    await page.locator('.exercise[data-kind="best"]').waitFor();
  }));

test("parts stay locked where the problem may be opened without the question", () =>
  opened({ document: grid(), tab: "Exercise" }, async (page) => {
    await page.getByLabel("Kind of question").selectOption("best");
    await page.getByLabel("Lock: the problem cannot be opened").uncheck();
    const locked = page.getByRole("group", { name: /Locked all the same/ });
    await page.getByText("the best plan are open to students then.").waitFor();
    await locked.getByLabel("walls").check();
    await page.getByText("keeps its solvers and best values back").waitFor();
    await locked.getByLabel("width").check();
    await assertNoBarrier(page, "parts that stay locked");
    await press(page, "Try it as a student");
    await page.getByText("This question is trivial").waitFor();
    await press(page, "Try it as a student");
    await press(page, "Open the problem in the playground");
    await page.locator("[data-board=actor]").waitFor();
    await openTab(page, "Edit");
    const change = async (field: string, value: string) => {
      await page.getByLabel(field, { exact: true }).fill(value);
      await page.getByLabel(field, { exact: true }).press("Enter");
    };
    const documentOf = () =>
      page.locator("mo-copp-playground").evaluate((element) => (element as MoCoppPlayground).document);
    const before = (await documentOf()) as GridworldDocument;
    assert.equal(await page.getByLabel("Columns", { exact: true }).isDisabled(), true);
    await page.getByText("Locked by the exercise: width stays as it is.").waitFor();
    await change("Rows", String(Number(before.height) + 1));
    const rows = async () => ((await documentOf()) as GridworldDocument).height;
    while ((await rows()) !== before.height + 1) await page.waitForTimeout(20);
    // As text, too; what is not locked may be rewritten, and the lock stays.
    await useDocument(page, JSON.stringify({ ...before, walls: [[0, 1]] }));
    await page.getByText("“walls” stays as the exercise has it: this part of the problem is locked.").first().waitFor();
    await useDocument(page, JSON.stringify(before));
    await statusIs(page, "idle");
    await useDocument(page, JSON.stringify({ ...before, walls: [[0, 1]] }));
    await page.getByText("“walls” stays as the exercise has it: this part of the problem is locked.").first().waitFor();
    assert.deepEqual(await documentOf(), before);
  }));

test("a link is offered where it opens the exercise, and keeps what the page's address says for itself", async () => {
  const host = await startHost();
  host.own.set("favicon.ico", { body: "" });
  const course = (attributes: string) => ({
    body: `<!doctype html><html lang="en"><title>Course</title><script type="module" src="mo-copp-playground.js"></script>
      <main><h1>Week 3</h1><mo-copp-playground ${attributes}></mo-copp-playground></main>`,
  });
  host.own.set("off.html", course('link="off"'));
  host.own.set("view.html", course(""));
  await visit(
    async ({ page }) => {
      const form = async (at: string) => {
        await page.goto(at);
        await statusIs(page, "optimal");
        await openTab(page, "Exercise");
        await page.getByLabel("Kind of question").selectOption("best");
      };
      const copied = async () => {
        await page.evaluate(() => navigator.clipboard.writeText(""));
        await press(page, "Copy a link");
        await page.getByText("Copied.").waitFor();
        return page.evaluate(() => navigator.clipboard.readText());
      };
      await form(`${host.address}off.html?x=1`);
      assert.equal(await page.getByRole("button", { name: "Copy a link" }).count(), 0);
      assert.equal(await page.getByRole("button", { name: "Copy code for a page" }).count(), 1);
      await form(`${host.address}view.html?id=42&src=a%20b`);
      const link = await copied();
      assert.ok(link.startsWith(`${host.address}view.html?id=42&src=a%20b#1.`), link);
      await page.goto("about:blank");
      await page.goto(link);
      await page.locator('.exercise[data-kind="best"]').waitFor();
      // What the playground's own page is asked by its address is not what the link is to open.
      await form(`${host.address}index.html?problem=corridor&step=1&lang=en`);
      const own = await copied();
      assert.ok(own.startsWith(`${host.address}index.html?lang=en#1.`), own);
      await page.goto("about:blank");
      await page.goto(own);
      await page.locator('.exercise[data-kind="best"]').waitFor();
    },
    { permissions: ["clipboard-read", "clipboard-write"] },
  );
});
