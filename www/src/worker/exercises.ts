// Exercises in the worker: questions, verdicts and pictures, all of the full core.
import type { PictureOptions } from "../core.js";
import { type Core, exercisesOf } from "./cores.js";
import type { Answer, Seed, Task } from "./protocol.js";

type Of<Kind extends Task["kind"]> = Extract<Task, { kind: Kind }>;
type Exercise = InstanceType<ReturnType<typeof exercisesOf>["Exercise"]>;

/** The exercise that was asked about last. */
let posed: { core: Core; document: string; seed: string; exercise: Exercise } | null = null;

function exerciseOf(core: Core, document: string, seed: Seed): Exercise {
  const key = JSON.stringify(seed);
  if (posed?.core !== core || posed.document !== document || posed.seed !== key) {
    const { Exercise, seedOf } = exercisesOf(core);
    const exercise = new Exercise(document, typeof seed === "number" ? seed : seedOf(seed.name));
    posed?.exercise.free();
    posed = { core, document, seed: key, exercise };
  }
  return posed.exercise;
}

export function asked(core: Core, { document, seed }: Of<"exercise">): Answer {
  const question = exerciseOf(core, document, seed).question();
  const plan = question.plan ?? [];
  const board = question.hide.includes("beliefs") ? "actor" : "all";
  // Who guesses the goal must not see which it is; what observers believe stands in the captions.
  const options = {
    board,
    captions: board === "all",
    true_goal: question.kind !== "guess",
    ended: question.plan !== undefined,
  } as const;
  const { picture } = pictureOf(core, JSON.stringify(question.document), plan, options);
  return { kind: "asked", question, picture };
}

export function judged(core: Core, { document, seed, choices, attempts, hints }: Of<"judge">): Answer {
  const verdict = exerciseOf(core, document, seed).check(Uint32Array.from(choices), attempts, hints);
  return { kind: "judged", verdict };
}

export function sketched(core: Core, { document, plan, board }: Of<"sketch">): Answer {
  exercisesOf(core);
  return { kind: "sketched", ...pictureOf(core, document, plan, { board, captions: board === "all", ended: false }) };
}

function pictureOf(core: Core, document: string, plan: string[], options: PictureOptions) {
  const problem = new core.Problem(document);
  try {
    const last = problem.overview(plan, 1).steps.at(-1) ?? null;
    const drawn = problem.picture(plan, options);
    // The description that a picture carries tells what observers believe; the page's own words stand beside it.
    const picture = drawn.replace(/<desc>[^<]*<\/desc>/, "");
    return { picture, next: problem.next(plan), last };
  } finally {
    problem.free();
  }
}
