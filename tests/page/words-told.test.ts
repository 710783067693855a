// What the observers are told stands beside each question, and what is too long for that where it is said to stand.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { parted } from "../../www/src/exercise/words/told.js";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { explicit } from "./support/documents.js";
import { give, openExercise } from "./support/exercises.js";

const folder = new URL("../../examples/", import.meta.url);
const exercises = readdirSync(new URL("exercises/", folder)).map((file) => file.replace(/\.json$/, ""));
const example = (name: string) => JSON.parse(readFileSync(new URL(`${name}.json`, folder), "utf8"));

const told = (page: Page) => page.getByRole("list", { name: "What the observers are told" });

async function ask(page: Page, document: object, exercise: object): Promise<void> {
  await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
  await give(page, JSON.stringify({ ...document, exercise }));
  await page.locator("#exercise-question").waitFor();
}

for (const viewport of [
  { width: 1280, height: 800 },
  { width: 390, height: 844 },
])
  test(`each of the twelve exercises says what both observers are told, ${viewport.width} pixels wide`, () =>
    visit(
      async ({ page }) => {
        for (const name of exercises) {
          await openExercise(page, name);
          const sentences = await told(page).getByRole("listitem").allTextContents();
          for (const who of ["enemy", "friend"])
            assert(
              sentences.some((sentence) => sentence.startsWith(`The ${who} is told `)),
              `${name}: ${sentences}`,
            );
          assert.equal(await told(page).isVisible(), true, name);
          const wide = await page.evaluate("document.documentElement.scrollWidth - innerWidth");
          assert.equal(wide, 0, name);
        }
        await assertNoBarrier(page, "what the observers are told");
      },
      { viewport },
    ));

test("problems in PDDL and those that list their states say it too", () =>
  visit(async ({ page }) => {
    await ask(page, JSON.parse(explicit), { kind: "best" });
    await told(page).getByText("The friend is told “a” for a into s1; “b” for b into s2.").waitFor();
    await ask(page, example("blocksworld"), { kind: "best" });
    await told(page).getByText("The enemy is told of every action its name alone.").waitFor();
    assert.equal(await page.getByText("More of what they are told").count(), 0, "all of it is shown");
  }));

test("a table of more transitions than are read at once stands in the problem in words, as is said", () =>
  visit(async ({ page }) => {
    const states = Array.from({ length: 40 }, (_, index) => `s${index}`);
    const transitions = states.slice(1).map((state, index) => [`s${index}`, "go", state]);
    const sensor = states.slice(1).map((state) => ["go", state, "moved"]);
    const chain = {
      ...{ format: "explicit", states, actions: ["go"], transitions, initial_state: "s0", true_goal: "G1" },
      goals: [
        { name: "G1", states: ["s3"] },
        { name: "G2", states: ["s4"] },
      ],
      observers: { adversarial: { sensor }, cooperative: { sensor } },
    };
    await ask(page, chain, { kind: "best" });
    await told(page).getByText("The enemy knows the first state.").waitFor();
    await page.getByText("More of what they are told stands in “The problem in words”.").waitFor();
    await page.locator("summary", { hasText: "The problem in words" }).click();
    await page.locator("summary", { hasText: "The friend is told" }).click();
    await page.getByText("“moved” for go into s1").nth(1).waitFor();
  }));

test("of long sentences the longest give way, and as few as it takes", () => {
  const [short, long, longest] = [100, 450, 800].map((letters) => "a".repeat(letters)) as [string, string, string];
  const list = { said: "It may be any of these:", each: Array.from({ length: 90 }, () => "column 2, row 3") };
  assert.deepEqual(parted({ sentences: [short, long] }), { shown: [short, long], rest: { sentences: [], texts: [] } });
  assert.deepEqual(parted({ sentences: [longest, list, long, short] }), {
    shown: [long, short],
    rest: { sentences: [longest, list], texts: [] },
  });
});
