// Exercises on the page: each kind by keyboard alone and without barriers, what is hidden, the code and where it goes.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { Exercise, seedOf } from "./support/core.js";
import { exerciseText, give, hear, heardOn, openExercise as open, type Solved, solved } from "./support/exercises.js";
import { startHost } from "./support/host.js";
import { address } from "./support/site.js";

const ends = (page: Page, verdict: "right" | "wrong") => page.locator(`[data-verdict=${verdict}]`).waitFor();

/** Presses Tab until something has the focus. */
async function tabTo(page: Page, selector: string): Promise<void> {
  for (let presses = 0; presses < 60; presses += 1) {
    const there = await page.evaluate((selector) => document.activeElement?.matches(selector) ?? false, selector);
    if (there) return;
    await page.keyboard.press("Tab");
  }
  assert.fail(`no way to ${selector} by Tab`);
}

/** From the top of the page, by keys alone. */
async function fromTop(page: Page): Promise<void> {
  await page.evaluate(() => {
    (document.activeElement as HTMLElement | null)?.blur();
    document.querySelector<HTMLElement>("#exercise-title")?.setAttribute("tabindex", "-1");
    document.querySelector<HTMLElement>("#exercise-title")?.focus();
  });
}

async function answerByKeys(page: Page, { choices, form, kind }: Solved): Promise<void> {
  await fromTop(page);
  if (kind === "walk" || kind === "best") {
    for (const choice of choices) {
      const name = String(form.choices[choice]);
      const before = await page.locator("[data-walk]").textContent();
      await page.locator(`[data-action="${name}"][aria-disabled=false]`).waitFor();
      await page.locator(`[data-action="${name}"]`).focus();
      await page.keyboard.press("Enter");
      await page.waitForFunction((text) => document.querySelector("[data-walk]")?.textContent !== text, before);
    }
  } else if ((await page.locator(".cells").count()) > 0) {
    await tabTo(page, "[data-choice]");
    for (const choice of choices) await walkTo(page, String(form.choices[choice]));
  } else if ((await page.locator(".choices input[type=radio]").count()) > 0) {
    await tabTo(page, ".choices input");
    await page.keyboard.press("Space");
    for (let at = 0; at < (choices[0] ?? 0); at += 1) await page.keyboard.press("ArrowDown");
  } else {
    await tabTo(page, ".choices input");
    for (let at = 0; at <= Math.max(...choices); at += 1) {
      if (at > 0) await page.keyboard.press("Tab");
      if (choices.includes(at)) await page.keyboard.press("Space");
    }
  }
  await fromTop(page);
  await tabTo(page, ".answer .primary");
  await page.keyboard.press("Enter");
}

/** Goes to a cell by the arrow keys and chooses it. */
async function walkTo(page: Page, cell: string): Promise<void> {
  const [column = 0, row = 0] = cell.split(",").map(Number);
  const here = async () =>
    (await page.evaluate(() => document.activeElement?.getAttribute("data-choice") ?? "")).split(",").map(Number);
  // Cells that are no choice are passed: where a way is barred, another one is taken.
  for (let steps = 0; steps < 80; steps += 1) {
    const [x = 0, y = 0] = await here();
    if (x === column && y === row) break;
    const across = x < column ? "ArrowRight" : x > column ? "ArrowLeft" : null;
    const down = y < row ? "ArrowDown" : y > row ? "ArrowUp" : null;
    const first = steps % 2 === 0 ? (across ?? down) : (down ?? across);
    await page.keyboard.press(first ?? "ArrowUp");
  }
  assert.deepEqual(await here(), [column, row]);
  await page.keyboard.press("Space");
}

for (const name of [
  "01-possible-goals",
  "02-belief",
  "03-guess",
  "05-start",
  "06-camera",
  "07-wall",
  "10-walk-both",
  "12-best",
]) {
  test(`by keys alone and without barriers: ${name}`, () =>
    visit(async ({ page }) => {
      await open(page, name);
      await assertNoBarrier(page, `${name}, before an answer`);
      await answerByKeys(page, solved(name));
      await ends(page, "right");
      await page.locator("mo-copp-playground[data-exercise=right]").waitFor();
      // The keyboard stays where it was: the button that was pressed has the focus still.
      assert.equal(await page.evaluate(() => document.activeElement?.textContent?.trim()), "Check the answer");
      assert.equal(await page.locator(".answer .primary").getAttribute("aria-disabled"), "true");
      const code = await page.getByLabel("Answer code").inputValue();
      assert.match(code, /^([0-9A-Z]{5}-)+[0-9A-Z]{1,5}$/);
      await page.locator(".exercise details").evaluate((details) => details.setAttribute("open", ""));
      await assertNoBarrier(page, `${name}, answered`);
    }));
}

test("a link asks for the student's name where the question varies, and goes on with that one's question and answer", () =>
  visit(async ({ page }) => {
    const seed = seedOf("Ada Lovelace");
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    await give(page, exerciseText("01-possible-goals"));
    const name = page.getByLabel("Your name or number");
    await name.waitFor();
    assert.equal(await page.locator("#exercise-question").count(), 0, "no question before the name");
    await assertNoBarrier(page, "a name is asked for");
    await name.fill(" Ada Lovelace ");
    await page.keyboard.press("Enter");
    await page.locator(`.exercise[data-seed="${seed}"]`).waitFor();
    await page.getByText("This is the question of Ada Lovelace.").waitFor();
    assert(await name.evaluate((field) => document.activeElement === field));
    for (const choice of solved("01-possible-goals", seed).choices)
      await page.locator(".choices input").nth(choice).check();
    await page.getByRole("button", { name: "Check the answer" }).click();
    await ends(page, "right");
    const before = await page.evaluate(() => location.hash);
    const code = await page.getByLabel("Answer code").inputValue();
    // The next address holds the name and the answer.
    await page.waitForFunction((before) => location.hash !== before, before);
    await page.reload();
    await page.locator(`.exercise[data-seed="${seed}"]`).waitFor();
    assert.equal(await page.getByLabel("Answer code").inputValue(), code);
    // Another name, another question; the answer was not its.
    await name.fill("Grace");
    await page.getByRole("button", { name: "Show my question" }).click();
    await page.locator(`.exercise[data-seed="${seedOf("Grace")}"]`).waitFor();
    assert.equal(await page.getByLabel("Answer code").count(), 0);
    // An address that names a student asks for nothing.
    const link = page.url().replace("#", "?student=Ada#");
    await page.goto("about:blank");
    await page.goto(link);
    await page.locator(`.exercise[data-seed="${seedOf("Ada")}"] #exercise-question`).waitFor();
    assert.equal(await name.count(), 0);
  }));

test("an answer without a choice takes an attempt only when it is meant, and none where it cannot be right", () =>
  visit(async ({ page }) => {
    await open(page, "01-possible-goals");
    const check = page.getByRole("button", { name: "Check the answer" });
    await check.click();
    await page.getByText("Nothing is chosen. If that is your answer, check it again.").waitFor();
    await page.getByText("3 attempts left.").waitFor();
    await check.click();
    await ends(page, "wrong");
    await page.getByText("2 attempts left.").waitFor();
    assert.equal(await page.getByText("Nothing is chosen.").count(), 0);
    await open(page, "02-belief");
    await check.click();
    await page.getByText("Nothing is chosen yet.").waitFor();
    await check.click();
    await page.getByText("3 attempts left.").waitFor();
    // The cells are numbered as what is said of an answer names them.
    const edges = await page.locator(".cells .edge").allTextContents();
    const { width, height } = JSON.parse(exerciseText("02-belief"));
    assert.deepEqual(edges, ["", ...Array(width).keys(), ...Array(height).keys()].map(String));
  }));

test("a wrong answer is contradicted by a walk, attempts run out, hints are counted in the code", () =>
  visit(async ({ page }) => {
    await open(page, "01-possible-goals");
    const check = page.getByRole("button", { name: "Check the answer" });
    await page.getByRole("button", { name: /^Show a hint/ }).click();
    assert.equal(await page.locator(".hints li").count(), 1);
    for (const [attempt, goal] of ["G1", "G3", "G4"].entries()) {
      await page.getByLabel(goal, { exact: true }).check();
      await check.click();
      await ends(page, "wrong");
      assert.match((await page.locator(".verdict").textContent()) ?? "", /possible for the enemy/);
      await page.getByText(attempt === 2 ? "No attempts left." : `attempt${attempt === 1 ? "" : "s"} left.`).waitFor();
    }
    await assertNoBarrier(page, "a wrong answer");
    await page.getByLabel("G3", { exact: true }).uncheck();
    assert.equal(await check.getAttribute("aria-disabled"), "true");
    const said = await page.locator(".tally").textContent();
    await check.click({ force: true });
    assert.equal(await page.locator(".tally").textContent(), said);
    const code = await page.getByLabel("Answer code").inputValue();
    const exercise = new Exercise(exerciseText("01-possible-goals"), 0);
    assert.equal(code, exercise.check(Uint32Array.from([0, 2, 3]), 3, 1).code);
  }));

test("solvers, plans, the best value and the other boards are not on the page of a question", () =>
  visit(async ({ page }) => {
    await open(page, "03-guess");
    for (const hidden of ["[role=tab]", ".stage", "[data-board]", ".stepper"])
      assert.equal(await page.locator(hidden).count(), 0, hidden);
    assert.equal(await page.locator("mo-copp-playground").getAttribute("data-gd"), null);
    const words = await page.locator(".exercise").innerText();
    assert(!/north, west/.test(words), "the walk is kept back");
    await page.locator(".exercise summary").click();
    assert(!(await page.locator(".exercise").innerText()).includes("true goal"));
    const picture = (await page.locator(".exercise img").first().getAttribute("src")) ?? "";
    assert(decodeURIComponent(picture).includes("<svg"));
  }));

test("as an element: seed, student, a block by attribute, the value that a form sends, score and answer as events", async () => {
  const host = await startHost();
  const { exercise, ...plain } = JSON.parse(exerciseText("06-camera"));
  host.own.set("favicon.ico", { body: "" });
  host.own.set("plain.json", { body: JSON.stringify(plain) });
  host.own.set("goals.json", { body: exerciseText("01-possible-goals") });
  host.own.set("page.html", {
    body: `<!doctype html><html lang="en"><title>Course</title><script type="module" src="mo-copp-playground.js"></script>
      <main><h1>Week 3</h1><form><mo-copp-playground id="one" name="q1" src="goals.json" seed="7" link="off"></mo-copp-playground></form>
      <mo-copp-playground id="two" src="plain.json" student="Ada" link="off" exercise='${JSON.stringify(exercise)}'></mo-copp-playground></main>`,
  });
  await visit(async ({ page }) => {
    await page.goto(`${host.address}page.html`);
    await hear(page);
    const [one, two] = [page.locator("#one"), page.locator("#two")];
    await one.locator('.exercise[data-seed="7"]').waitFor();
    await two.locator('.exercise[data-kind="placement"]').waitFor();
    const seed = Number(await two.locator(".exercise").getAttribute("data-seed"));
    assert(seed > 0 && seed < 1_000_000);
    const { choices } = solved("01-possible-goals", 7);
    for (const choice of choices) await one.locator(".choices input").nth(choice).check();
    const sent = () => page.evaluate(() => new FormData(document.querySelector("form") ?? undefined).get("q1"));
    assert.equal(await sent(), null);
    await one.getByRole("button", { name: "Check the answer" }).click();
    await one.locator("[data-verdict=right]").waitFor();
    const code = await one.getByLabel("Answer code").inputValue();
    assert.equal(await sent(), code);
    assert.deepEqual(await heardOn(page), [
      ["mo-copp-answer", { code, score: 1 }],
      ["mo-copp-score", { score: 1 }],
    ]);
    // Another seed is another question, and the old answer is not its.
    await one.evaluate((element) => element.setAttribute("seed", "8"));
    await one.locator('.exercise[data-seed="8"]').waitFor();
    assert.equal(await one.getByLabel("Answer code").count(), 0);
  });
});

test("a frame reports the score by SPLICE, and goes on with what was kept", () =>
  visit(async ({ page }) => {
    await page.route(`${address}lesson/exercise.json`, (route) =>
      route.fulfill({ contentType: "application/json", body: exerciseText("01-possible-goals") }),
    );
    await page.route(`${address}lesson/frame.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><html lang="en"><title>Around</title>
          <script>window.heard = []; addEventListener("message", ({ data }) => window.heard.push(data));</script>
          <iframe src="../index.html?src=lesson/exercise.json&amp;seed=3&amp;hide=intro,footer" title="Frame" width="900" height="900"></iframe>`,
      }),
    );
    await page.goto(`${address}lesson/frame.html`);
    const frame = page.frameLocator("iframe");
    await frame.locator('.exercise[data-seed="3"]').waitFor();
    for (const choice of solved("01-possible-goals", 3).choices)
      await frame.locator(".choices input").nth(choice).check();
    await frame.getByRole("button", { name: "Check the answer" }).click();
    await frame.locator("[data-verdict=right]").waitFor();
    await page.waitForFunction(() =>
      (
        window as unknown as {
          heard: { subject?: string; score?: number; state?: { answer?: { attempts: number } } }[];
        }
      ).heard.some(
        ({ subject, score, state }) =>
          subject === "SPLICE.reportScoreAndState" && score === 1 && state?.answer?.attempts === 1,
      ),
    );
    const kept = await page.evaluate(
      () =>
        (window as unknown as { heard: { event?: string; state?: object }[] }).heard
          .filter(({ event }) => event === "state")
          .at(-1)?.state,
    );
    await page.reload();
    await frame.locator('.exercise[data-seed="3"]').waitFor();
    await page.evaluate(
      (state) =>
        document
          .querySelector("iframe")
          ?.contentWindow?.postMessage({ subject: "SPLICE.getState.response", state }, "*"),
      kept,
    );
    await frame.getByText("2 attempts left.").waitFor();
    assert.equal(await frame.locator(".choices input:checked").count(), solved("01-possible-goals", 3).choices.length);
  }));

test("an exercise that is wrong is refused with its place, and a problem after an exercise is a problem", () =>
  visit(async ({ page }) => {
    await open(page, "01-possible-goals");
    const set = (text: string) => give(page, text);
    await set(exerciseText("01-possible-goals").replace('"attempts": 3', '"attempts": 300'));
    await page.getByText("exercise.attempts: found 300, expected a whole number from 1 to 99").waitFor();
    const { exercise: _, ...plain } = JSON.parse(exerciseText("01-possible-goals"));
    await set(JSON.stringify(plain));
    await page.locator("[data-board=actor]").waitFor();
    assert.equal(await page.locator(".exercise").count(), 0);
  }));

test("the picture of a question has the colours of the page, and follows them", () =>
  visit(
    async ({ page }) => {
      await open(page, "10-walk-both");
      const drawn = (theme: string) =>
        page.locator(`.exercise [data-of=actor] img[src*="data-theme%3D%22${theme}%22"]`).waitFor();
      await drawn("dark");
      await page.emulateMedia({ colorScheme: "light" });
      await drawn("light");
      await page.locator("mo-copp-playground").evaluate((element) => element.setAttribute("theme", "dark"));
      await drawn("dark");
    },
    { colorScheme: "dark" },
  ));

test("no picture of a question tells what observers believe where that is hidden, and none is wider than the screen", () =>
  visit(
    async ({ page }) => {
      for (const name of ["01-possible-goals", "02-belief", "03-guess", "06-camera", "10-walk-both"]) {
        await open(page, name);
        await page.locator("#exercise-title", { hasText: JSON.parse(exerciseText(name)).exercise.title }).waitFor();
        const boards = name === "10-walk-both" ? ["actor", "adversarial", "cooperative"] : ["actor"];
        await page
          .locator(".exercise figure")
          .nth(boards.length - 1)
          .waitFor();
        const shown = await page.locator(".exercise figure").evaluateAll((figures) =>
          figures.map((figure) => {
            const address = figure.querySelector("img")?.src ?? "";
            const svg = decodeURIComponent(address.slice(address.indexOf(",") + 1));
            const picture = new DOMParser().parseFromString(svg, "image/svg+xml");
            const told = [...picture.querySelectorAll("text, desc")].map(({ textContent }) => textContent ?? "");
            return { board: (figure as HTMLElement).dataset.of, told: told.join(" ") };
          }),
        );
        assert.deepEqual(
          shown.map(({ board }) => board),
          boards,
          name,
        );
        const widths = await page
          .locator(".exercise figure img")
          .evaluateAll((images) => images.map((image) => image.getBoundingClientRect().width));
        const [agent = 0, ...others] = widths;
        assert(agent > 200, `${name}: the agent's board is ${agent} px wide`);
        for (const width of others)
          assert(width > 100 && width <= agent, `${name}: an observer's board is ${width} px wide`);
        for (const { told } of shown) assert(!/possible|believes/i.test(told), `${name}: ${told}`);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert(wide <= 0, `${name} is ${wide} px too wide`);
      }
    },
    { viewport: { width: 320, height: 700 } },
  ));

/** The numbers in the picture of the agent's board. */
const numbersOn = (page: Page): Promise<number[]> =>
  page.locator(".exercise [data-of=actor] img").evaluate((image) => {
    const address = (image as HTMLImageElement).src;
    const svg = decodeURIComponent(address.slice(address.indexOf(",") + 1));
    const texts = [...new DOMParser().parseFromString(svg, "image/svg+xml").querySelectorAll("text")];
    return texts
      .map(({ textContent }) => textContent ?? "")
      .filter((text) => /^\d+$/.test(text))
      .map(Number);
  });

test("a cell has one name: on the board, in the form and in what is said of an answer", () =>
  visit(async ({ page }) => {
    const upTo = (count: number) => Array.from({ length: count }, (_, index) => index);
    for (const name of ["05-start", "09-walk-difference"]) {
      await open(page, name);
      await page.locator(".exercise [data-of=actor] img").waitFor();
      const { width, height } = JSON.parse(exerciseText(name));
      assert.deepEqual(await numbersOn(page), [...upTo(width), ...upTo(height)], name);
    }
    const action = page.locator("[data-action][aria-disabled=false]").first();
    await action.click();
    const where = page.locator(".walk-form .where, .choices .where");
    await where.getByText("After 1 step: column").waitFor();
    const cell = /column \d+, row \d+/.exec((await where.textContent()) ?? "")?.[0] ?? assert.fail("no cell is named");
    await page.getByRole("button", { name: "Check the answer" }).click();
    await page.locator("[data-verdict=wrong] ~ p", { hasText: `ends at ${cell}` }).waitFor();
    // A cell that is chosen has its name, and the verdict speaks of it by the same one.
    await open(page, "07-wall");
    await page.locator('[data-choice="0,0"]').click();
    assert.equal(await page.locator('[data-choice="0,0"]').getAttribute("aria-label"), "column 0, row 0");
    await page.getByRole("button", { name: "Check the answer" }).click();
    await page.locator("[data-verdict=wrong] ~ p", { hasText: "With the wall in column 0, row 0, " }).waitFor();
    for (const text of await page.locator(".exercise").allInnerTexts())
      assert(!/\[\d+, ?\d+\]/.test(text), `a cell is named otherwise: ${text}`);
  }));
