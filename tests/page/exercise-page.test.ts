// The question that a page asks: no file and no link takes its place, and no answer to another one counts.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { pack } from "../../www/src/share/packed.js";
import { visit } from "./support/browser.js";
import { Exercise } from "./support/core.js";
import { drop } from "./support/drop.js";
import { exerciseText, give, hear, heardOn, problemText, solved } from "./support/exercises.js";
import { startHost } from "./support/host.js";
import { openTab, press } from "./support/playground.js";
import { address } from "./support/site.js";

const asked = "01-possible-goals";
const other = "03-guess";
const seven = solved(asked, 7);
/** What may be opened without its question. */
const open = JSON.parse(exerciseText(asked));
const unlocked = JSON.stringify({ ...open, exercise: { ...open.exercise, lock: false } });

async function course(body: string): Promise<string> {
  const host = await startHost();
  host.own.set("favicon.ico", { body: "" });
  host.own.set("goals.json", { body: exerciseText(asked) });
  host.own.set("unlocked.json", { body: unlocked });
  host.own.set("page.html", {
    body: `<!doctype html><html lang="en"><title>Course</title><script type="module" src="mo-copp-playground.js"></script>
      <main><h1>Week 3</h1><form>${body}</form></main>`,
  });
  return `${host.address}page.html`;
}

const sent = (page: Page) => page.evaluate(() => new FormData(document.querySelector("form") ?? undefined).get("q"));

async function answer(page: Page, choices: readonly number[]): Promise<void> {
  for (const choice of choices) await page.locator(".choices input").nth(choice).check();
  await press(page, "Check the answer");
  await page.locator("[data-verdict]").waitFor();
}

for (const [way, element] of [
  ["src", '<mo-copp-playground src="goals.json" seed="7" link="off" name="q"></mo-copp-playground>'],
  [
    "a script in it",
    `<mo-copp-playground seed="7" link="off" name="q"><script type="application/json">${exerciseText(asked)}</script></mo-copp-playground>`,
  ],
  [
    "its attribute",
    `<mo-copp-playground seed="7" link="off" name="q" exercise='${JSON.stringify(open.exercise)}'>
     <script type="application/json">${problemText(asked)}</script></mo-copp-playground>`,
  ],
] as const)
  test(`no file takes the place of a question that the page asks by ${way}`, async () => {
    const at = await course(element);
    await visit(async ({ page }) => {
      await page.goto(at);
      const question = page.locator('.exercise[data-seed="7"][data-kind="possible-goals"]');
      await question.waitFor();
      const said = page.getByText("This page asks this question: no file takes its place.");
      for (const text of [exerciseText(other), problemText(asked)]) {
        await drop(page, "mo-copp-playground", { files: [{ name: "mine.json", text }] }, async () => {
          assert.equal(await page.getByText("Drop the problem document here").count(), 0);
          await said.first().waitFor();
        });
        await page.getByRole("alert").and(page.locator(":has-text('no file takes its place')")).first().waitFor();
        assert.equal(await question.count(), 1);
        assert.equal(await page.locator("mo-copp-playground[data-status=error]").count(), 0, "the question is whole");
        await press(page, "Close the message");
        assert.equal(await page.getByRole("alert").getByText("no file takes its place").count(), 0, "it is closed");
      }
      await answer(page, seven.choices);
      assert.equal(await sent(page), await page.getByLabel("Answer code").inputValue());
    });
  });

test("a script of the page may ask another question, and files are taken where the page asks none", async () => {
  const at = await course('<mo-copp-playground src="goals.json" seed="7" link="off" name="q"></mo-copp-playground>');
  await visit(async ({ page }) => {
    await page.goto(at);
    await page.locator('.exercise[data-kind="possible-goals"]').waitFor();
    await hear(page);
    await give(page, exerciseText("06-camera"));
    await page.locator('.exercise[data-kind="placement"]').waitFor();
    await page.locator(`[data-choice]`).first().click();
    await press(page, "Check the answer");
    await page.locator("[data-verdict]").waitFor();
    assert.equal((await heardOn(page)).length, 2);
    assert.equal(await sent(page), await page.getByLabel("Answer code").inputValue());
    await give(page, problemText(asked));
    await page.locator("[data-board=actor]").waitFor();
    await drop(page, "mo-copp-playground", { files: [{ name: "mine.json", text: exerciseText(other) }] });
    await page.locator('.exercise[data-kind="guess"]').waitFor();
    // The playground's own page takes files over any question, but for one that its address asks.
    await page.goto(address);
    await give(page, exerciseText(asked));
    await page.locator("#exercise-title").waitFor();
    await drop(page, "mo-copp-playground", { files: [{ name: "mine.json", text: problemText(asked) }] });
    await page.locator("[data-board=actor]").waitFor();
    await page.route(`${address}week.json`, (route) =>
      route.fulfill({ contentType: "application/json", body: exerciseText(asked) }),
    );
    await page.goto(`${address}?src=week.json&seed=7`);
    await page.locator('.exercise[data-seed="7"]').waitFor();
    await drop(page, "mo-copp-playground", { files: [{ name: "mine.json", text: problemText(asked) }] });
    await page.getByText("no file takes its place").first().waitFor();
    assert.equal(await page.locator('.exercise[data-seed="7"]').count(), 1);
  });
});

test("beside the question of the page nothing counts: no exercise that is tried, no guess", async () => {
  const at = await course('<mo-copp-playground src="unlocked.json" seed="7" link="off" name="q"></mo-copp-playground>');
  await visit(async ({ page }) => {
    await page.goto(at);
    await page.locator('.exercise[data-seed="7"]').waitFor();
    const wrong = [...Array(seven.count).keys()].find((choice) => !seven.choices.includes(choice)) ?? 0;
    await answer(page, [wrong]);
    const code = await page.getByLabel("Answer code").inputValue();
    await hear(page);
    await press(page, "Open the problem in the playground");
    await openTab(page, "Exercise");
    await page.getByLabel("Kind of question").selectOption("walk");
    await page.getByLabel("Goal difference of at least").fill("-1");
    await press(page, "Try it as a student");
    await page.getByText("This question is trivial").waitFor();
    await press(page, "Try it as a student");
    await page.locator('.exercise[data-kind="walk"]').waitFor();
    const made = await page
      .locator("mo-copp-playground")
      .evaluate((element) => JSON.stringify((element as MoCoppPlayground).document));
    const { solution } = new Exercise(made, 0).solution();
    for (const action of (solution?.answer ?? []) as string[])
      await page.locator(`[data-action="${action}"][aria-disabled=false]`).click();
    await press(page, "Check the answer");
    await page.locator("[data-verdict=right]").waitFor();
    assert.deepEqual(await heardOn(page), []);
    assert.equal(await sent(page), code);
    await press(page, "Back to editing");
    await press(page, "Back to the question");
    await page.getByText("2 attempts left.").waitFor();
    // The core has judged the answer again.
    await page.getByLabel("Answer code").waitFor();
    assert.equal(await sent(page), code);
  });
});

test("no link takes the place of a question that the page asks, and one of its own goes on", async () => {
  const at = await course('<mo-copp-playground src="goals.json" seed="7" name="q"></mo-copp-playground>');
  const link = async (document: string, answer: object) =>
    `${at}#${await pack(JSON.stringify({ document, form: {}, step: 0, tab: "", mode: "plan", answer }))}`;
  await visit(async ({ page }) => {
    const own = page.locator('.exercise[data-seed="7"][data-kind="possible-goals"]');
    const said = page.getByText("This link holds another problem than this page asks about");
    const kept = { choices: [0], attempts: 2, hints: 0 };
    await page.goto(await link(exerciseText(other), kept));
    await own.waitFor();
    await said.waitFor();
    assert.equal(await page.locator(".choices input:checked").count(), 0);
    // Followed while the question is open, too.
    await press(page, "Close the message");
    await page.goto(await link(problemText(asked), kept));
    await said.waitFor();
    assert.equal(await own.count(), 1);
    await page.goto("about:blank");
    await page.goto(await link(exerciseText(asked), kept));
    await page.getByText("1 attempt left.").waitFor();
    assert.equal(await page.locator(".choices input:checked").count(), 1);
    assert.equal(await said.count(), 0);
  });
});

test("while the question of the page is on its way, no file takes its place", async () => {
  const at = await course('<mo-copp-playground src="goals.json" seed="7" link="off" name="q"></mo-copp-playground>');
  await visit(async ({ page }) => {
    let come = () => {};
    const held = new Promise<void>((resolve) => {
      come = resolve;
    });
    await page.route("**/goals.json", async (route) => {
      await held;
      await route.continue();
    });
    await page.goto(at);
    await page.getByText("Loading…").first().waitFor();
    await hear(page);
    await drop(page, "mo-copp-playground", { files: [{ name: "mine.json", text: exerciseText(other) }] });
    await page.getByText("still being opened: no file takes its place").first().waitFor();
    assert.equal(await page.locator(".exercise[data-kind=guess]").count(), 0);
    come();
    await page.locator('.exercise[data-seed="7"][data-kind="possible-goals"]').waitFor();
    await answer(page, seven.choices);
    assert.equal((await heardOn(page)).length, 2);
    assert.equal(await sent(page), await page.getByLabel("Answer code").inputValue());
  });
});

for (const link of [false, true])
  test(`where the question of the page is missing, one that ${link ? "a link" : "a file"} brings does not count`, async () => {
    const at = await course(
      `<mo-copp-playground src="lacking.json" seed="7" ${link ? "" : 'link="off"'} name="q"></mo-copp-playground>`,
    );
    const state = { document: exerciseText(asked), form: {}, step: 0, tab: "", mode: "plan" };
    await visit(
      async ({ page }) => {
        await page.goto(link ? `${at}#${await pack(JSON.stringify(state))}` : at);
        if (!link) {
          await page.getByText("lacking.json").first().waitFor();
          await drop(page, "mo-copp-playground", { files: [{ name: "mine.json", text: exerciseText(asked) }] });
        }
        await page.locator('.exercise[data-seed="7"]').waitFor();
        await hear(page);
        await answer(page, seven.choices);
        await page.getByLabel("Answer code").waitFor();
        assert.deepEqual(await heardOn(page), []);
        assert.equal(await sent(page), null);
      },
      { quiet: false },
    );
  });

/** What gives a question away, or stands there for nothing. */
const workplace = ".stage, .stepper, [part=workbench], [role=tab], [part=goals], .problem-bar, [data-board], .exercise";

test("a question that can't be opened shows why and nothing else", async () => {
  const problem = JSON.parse(problemText("09-walk-difference"));
  const impossible = JSON.stringify({ ...problem, exercise: { kind: "walk", at_most: 1 } });
  const at =
    await course(`<mo-copp-playground link="off" name="q"><script type="application/json">${impossible}</script>
    </mo-copp-playground>`);
  await visit(
    async ({ page }) => {
      await page.goto(at);
      const one = page.locator("mo-copp-playground");
      await one.getByRole("alert").getByText("found no walk answers the question").waitFor();
      assert.equal(await one.locator(workplace).count(), 0);
      assert.equal(await one.getByRole("button", { name: "Close the message" }).count(), 0);
      // The next problem that is given is shown as ever.
      await give(page, problemText("09-walk-difference"));
      await one.locator("[data-board=actor]").waitFor();
      assert.equal(await one.getByRole("tab").count(), 8);
    },
    { quiet: false },
  );
});

test("a problem that can't be loaded leaves no empty parts, and others can be opened", () =>
  visit(
    async ({ page }) => {
      await page.goto(`${address}index.html?src=missing.json`);
      await page.getByRole("alert").getByText("was answered with 404").waitFor();
      assert.equal(await page.locator(workplace.replace(" .problem-bar,", "")).count(), 0);
      await page.getByRole("button", { name: "Next problem" }).click();
      await page.locator("[data-board=actor]").waitFor();
      assert((await page.getByRole("tab").count()) > 0, "the tabs come with the problem");
    },
    { quiet: false },
  ));
