// What the form of an exercise begins with: on the problems that the page brings, a question that can be asked and is
// not trivial, whatever its kind, with nothing of the form touched.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { ExerciseDraft } from "../../www/src/state/exercise-draft.js";
import {
  type Kind,
  kindsOf,
  placesOf,
  type Shown,
  subjectOf,
  variableOf,
} from "../../www/src/state/exercise-subject.js";
import { differenceIn } from "../../www/src/state/goal-difference-text.js";
import { OpenProblem } from "../../www/src/state/open-problem.js";
import { differenceText } from "../../www/src/view/numbers.js";
import { Exercise, scene, solve } from "./support/core.js";

const untouched = () => new ExerciseDraft({ problem: new OpenProblem(), workbench: { id: "form" } });

const folder = new URL("../../www/problems/", import.meta.url);

function shownOf(text: string): Shown {
  const { outcome, trace } = solve(text, { solver: "exact" });
  const { goals, true_goal } = scene(text);
  return {
    document: JSON.parse(text),
    steps: trace.steps,
    step: 0,
    goals: goals.map(({ name }) => name),
    trueGoal: true_goal,
    best: outcome.goal_difference,
  };
}

/** What the core says of the exercise that an untouched form makes. */
function said(shown: Shown, kind: Kind): string {
  const draft = untouched();
  draft.edit({ kind });
  try {
    const text = JSON.stringify({ ...shown.document, exercise: draft.block(shown) });
    return new Exercise(text, 0).solution().solution?.remarks.join() ?? "";
  } catch (error) {
    return String(error);
  }
}

const trivial = "a shortest walk answers it";

/** Problems of which no better question of a kind is known: the form says what is wrong with it. */
const known: Record<string, Record<string, string>> = {
  "blind-enemy": {},
  "camera-zone": {},
  corridor: {},
  delivery: { walk: trivial, best: trivial },
  "eight-by-eight": {},
  "head-fake": {},
  parity: {},
  "stay-and-wait": {},
  "three-rooms": { walk: trivial, best: trivial, guess: "no other goal is in reach of so many steps" },
};

test("the form begins with questions that can be asked and are not trivial", () => {
  for (const [name, remarks] of Object.entries(known)) {
    const shown = shownOf(readFileSync(new URL(`${name}.json`, folder), "utf8"));
    for (const kind of kindsOf(shown.document))
      assert.equal(said(shown, kind), remarks[kind] ?? "", `${name}, ${kind}`);
  }
});

test("at a step that was chosen the question is about that step, and a guess about the whole plan", () => {
  const shown = { ...shownOf(readFileSync(new URL("eight-by-eight.json", folder), "utf8")), step: 3 };
  const plan = (kind: Kind) => {
    const draft = untouched();
    draft.edit({ kind });
    return (draft.block(shown) as { plan: string[] }).plan.length;
  };
  assert.equal(plan("belief"), 3);
  assert.equal(plan("guess"), shown.steps.length - 1);
});

test("what a format lacks is not offered", () => {
  const document = (name: string) => JSON.parse(readFileSync(new URL(`${name}.json`, folder), "utf8"));
  assert(!kindsOf(document("delivery")).includes("placement"));
  assert.deepEqual(variableOf(document("delivery"), "best"), ["true_goal"]);
  assert.deepEqual(variableOf(document("blocks"), "belief"), ["true_goal", "plan"]);
  assert.deepEqual(variableOf(document("eight-by-eight"), "belief"), ["start", "goals", "walls", "true_goal", "plan"]);
  assert.deepEqual(placesOf(document("box-pushing")), ["wall", "start"]);
  const told = { ...document("blocks"), problem: "(define (problem p) ; (:goal\n (:goal (on a b)))" };
  assert(!kindsOf(told).includes("guess") && kindsOf(document("blocks")).includes("guess"));
});

test("a goal difference is the exact one, typed as a fraction or with three decimals", () => {
  const thirds = readFileSync(new URL("../learn/figures/survivors.json", folder), "utf8");
  const shown = shownOf(thirds);
  const goals = shown.goals.length;
  assert.equal(shown.best, 2 / 3);
  // As the form begins, and as people type it; a rounded one must not ask for more than there is.
  for (const difference of [null, "2/3", " 2 / 3 ", "0.667", "0,667", "0.6667", "0.66666666"]) {
    const draft = untouched();
    draft.edit({ kind: "walk", difference });
    const block = draft.block(shown) as { goal_difference: unknown };
    assert.equal(block.goal_difference, 2 / 3, String(difference));
    const exercise = new Exercise(JSON.stringify({ ...shown.document, exercise: block }), 0);
    assert.equal(exercise.question().kind, "walk", "the core has an answer");
  }
  const draft = untouched();
  draft.edit({ kind: "walk" });
  assert.equal(subjectOf(draft.fields.value, shown).difference, "2/3");
  const numbers: [string, number, number | null][] = [
    ["-1/3", 4, -1 / 3],
    ["−0.333", 4, -1 / 3],
    ["0.6", 4, 0.6],
    ["0.5", 4, 0.5],
    ["0", 4, 0],
    ["1", 1, 1],
    ["1/0", 4, null],
    ["half", 4, null],
    ["", 4, null],
  ];
  for (const [text, goals, number] of numbers) assert.equal(differenceIn(text, goals), number, text);
  const texts: [number, string][] = [
    [2 / 3, "2/3"],
    [-1 / 3, "−1/3"],
    [1 - 2 / 3, "1/3"],
    [0.5, "1/2"],
    [17 / 96, "17/96"],
    [1, "1"],
    [-1, "−1"],
    [-0, "0"],
    [0.1234567, "0.123"],
  ];
  for (const [number, text] of texts) assert.equal(differenceText(number), text, text);
  assert(goals > 2, "more than two goals make thirds");
});
