// The problem of a question in words, for each format: everything that the picture and the document tell.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { deliveryInWords } from "../../www/src/exercise/words/delivery.js";
import { explicitInWords } from "../../www/src/exercise/words/explicit.js";
import { floorInWords } from "../../www/src/exercise/words/floor.js";
import { pddlInWords } from "../../www/src/exercise/words/pddl.js";
import { visit } from "./support/browser.js";
import { explicit } from "./support/documents.js";
import { give } from "./support/exercises.js";

const example = (name: string) =>
  JSON.parse(readFileSync(new URL(`../../examples/${name}.json`, import.meta.url), "utf8"));

test("box pushing and the recycling robot say where all begins, who doubts what, and what is told", () => {
  const { sentences, told } = floorInWords(example("box-pushing"));
  assert.deepEqual(sentences, [
    "5 columns from the left, 5 rows from the top, both counted from 0.",
    "The robot begins at column 2, row 3 and faces north.",
    "The box begins at column 2, row 1.",
    "Goals, each a cell for the box: G1 at column 3, row 0; G2 at column 1, row 0; G3 at column 0, row 0.",
    "The true goal: G1.",
  ]);
  assert.deepEqual(told.sentences, [
    "At first the enemy does not know which way the robot faces: it may be north, south, east or west.",
    "The enemy is told “move” for move-forward and stay; “turn” for turn-left and turn-right.",
    "At first the friend does not know which way the robot faces: it may be north, south, east or west.",
    "The friend is told “move-right” for move-forward and turn-right; “leftwards” for stay and turn-left.",
  ]);
  const robot = floorInWords(example("recycling-robot"));
  assert.deepEqual(robot.sentences.slice(1, 5), [
    "The robot begins at column 2, row 0 with battery 4 of 4; a move takes one.",
    "The can begins at column 1, row 0.",
    "The charger: column 2, row 3.",
    "Goals, each a cell for the can: there is a bin: G1 at column 0, row 1; G2 at column 2, row 0; G3 at column 1, row 3.",
  ]);
  const doubt = robot.told.sentences[0];
  assert(typeof doubt === "object", String(doubt));
  assert.equal(doubt.said, "At first the enemy does not know where the robot is. It may be any of these:");
  assert.deepEqual(doubt.each[0], "column 2, row 0");
});

test("deliveries and problems that list their states are sentences as well", () => {
  assert.deepEqual(deliveryInWords(example("delivery")).sentences.slice(0, 4), [
    "At the factory A lie a1 and a2.",
    "At the factory B lie b1 and b2.",
    "The truck is empty at first. It loads 2 of the packages, one after another, and then delivers them.",
    "Goals: each set of 2 packages.",
  ]);
  assert.match(
    String(deliveryInWords(example("delivery")).told.sentences.at(-1)),
    /^The friend is told “barcode A” for load a1 and load a2; “barcode B” for load b1 and load b2; “delivery” for deliver.$/,
  );
  const { sentences, texts, told } = explicitInWords(JSON.parse(explicit));
  assert.match(String(sentences[0]), /^\d+ states, \d+ actions\. The agent begins in \S+\.$/);
  assert.match(String(sentences[1]), /^What can be done: in \S+, \S+ leads to \S+/);
  assert.deepEqual(texts, []);
  assert.deepEqual(told.texts, []);
  assert.deepEqual(told.sentences.slice(-1), ["The friend is told “a” for a into s1; “b” for b into s2."]);
});

test("of PDDL the first state, the goals, the doubts and the sensors are told, and its own texts stand beside them", () => {
  const { sentences, texts, told } = pddlInWords(example("blocksworld"));
  assert.equal(
    sentences[0],
    "At first these hold, and nothing else: (handempty), (ontable c), (on e c), (on d e), (clear d), (ontable a), (on b a), (clear b).",
  );
  assert.equal(sentences[1], "The goal G1: (and (on b c) (on d b) (on e d) (on a e)).");
  assert.deepEqual(told.sentences, [
    "The enemy knows the first state.",
    "The enemy is told of every action its name alone.",
    "The friend knows the first state.",
    "To the friend these look alike: a and b (read as a-b); c, d and e (read as c-d-e).",
    "The friend is told of every action its name and its first object.",
  ]);
  assert.deepEqual(
    texts?.map(({ title }) => title),
    ["The actions, in PDDL", "The objects and the first state, in PDDL"],
  );
});

test("a question of box pushing shows its words, where the box begins, and states that can be searched", () =>
  visit(async ({ page }) => {
    await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
    const plan = ["move-forward", "move-forward", "turn-left"];
    const ask = (exercise: object) => give(page, JSON.stringify({ ...example("box-pushing"), exercise }));
    await ask({ kind: "belief", observer: "cooperative", plan });
    await page.getByText("The problem in words").click();
    await page.getByText("The box begins at column 2, row 1.").waitFor();
    await page.getByText("where the box begins, once it is elsewhere").waitFor();
    const list = page.getByRole("group", { name: "States", exact: true });
    const count = page.locator(".choices .count");
    const all = Number(/^([\d,]+) states/.exec((await count.textContent()) ?? "")?.[1]?.replace(",", ""));
    assert(all > 100, String(all));
    assert((await list.boundingBox())?.height ?? 10_000 < 500);
    const search = page.getByRole("searchbox", { name: "Search" });
    await search.fill("column 2, row 3, facing north");
    await page.getByText(/^[\d,]+ of [\d,]+ states/).waitFor();
    const found = await list.getByRole("checkbox").count();
    assert(found > 0 && found < all / 4, String(found));
    // What is typed as it stands in the list is of one thing: not of a robot here and a box there.
    await search.fill("facing north, box [3, 2]");
    await list.getByText("facing north · box column 3, row 2").first().waitFor();
    assert.equal(await list.getByText("box column 0, row 0").count(), 0);
    const names = await list.getByRole("checkbox").evaluateAll((boxes) => boxes.map((box) => box.ariaLabel ?? ""));
    assert(names.length > 0 && names.length < all / 4, String(names.length));
    for (const name of names) assert.match(name, /facing north · box column 3, row 2/);
    await search.fill("nothing like this");
    await page.getByText("No state has these words.").waitFor();
    await search.fill("");
    await list.getByRole("checkbox").first().check();
    await page.getByText(`${all.toLocaleString("en")} states, 1 chosen.`).waitFor();
    const pushes = [...plan, "move-forward", "turn-right", "move-forward", "turn-right", "stay", "move-forward"];
    await ask({ kind: "placement", observer: "adversarial", plan: pushes, place: "wall", goal: "G3", possible: false });
    await page.getByText("S the start of the robot · □ where the box begins").waitFor();
    await page.getByRole("button", { name: "column 2, row 1, where the box begins" }).waitFor();
  }));

test("an observer with one first state knows it", () => {
  const document = JSON.parse(explicit);
  const first = document.initial_state;
  const told = explicitInWords({
    ...document,
    observers: {
      adversarial: { ...document.observers.adversarial, initial_belief: [first] },
      cooperative: document.observers.cooperative,
    },
  }).told.sentences;
  assert.equal(told[0], "The enemy knows the first state.");
  const blocks = example("blocksworld");
  blocks.observers.adversarial.initial_belief = [{}];
  assert.equal(pddlInWords(blocks).told.sentences[0], "The enemy knows the first state.");
});
