// Exercises in the worker: questions, verdicts and pictures, all of the full core.
import { type Core, exercisesOf } from "./cores.js";
import { faultIn } from "./failure.js";
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
  return { kind: "asked", question: exerciseOf(core, document, seed).question() };
}

export function proved(core: Core, { document }: Of<"prove">): Answer {
  try {
    const exercise = exerciseOf(core, document, 0);
    const { solution } = exercise.solution();
    const variants = exercise.sample(document)?.remarks ?? [];
    const { choice, choices } = exercise.question().form;
    const states = choice === "state" ? choices.length : 0;
    return { kind: "proved", fault: null, remarks: solution?.remarks ?? [], variants, states };
  } catch (error) {
    const fault = faultIn(error);
    if (fault === null) throw error;
    return { kind: "proved", fault, remarks: [], variants: [], states: 0 };
  }
}

export function judged(core: Core, { document, seed, choices, attempts, hints }: Of<"judge">): Answer {
  const verdict = exerciseOf(core, document, seed).check(Uint32Array.from(choices), attempts, hints);
  return { kind: "judged", verdict };
}

export function sketched(core: Core, { document, plan, boards, options }: Of<"sketch">): Answer {
  exercisesOf(core);
  const problem = new core.Problem(document);
  try {
    const last = problem.overview(plan, 1).steps.at(-1) ?? null;
    const pictures = boards.map((board) => {
      // Answers and what is said of them name cells by their numbers; the observers' boards are too small for any.
      const numbers = board === "actor";
      const drawn = problem.picture(plan, { ...options, board, numbers, captions: false });
      // The description that a picture carries tells what observers believe; the page's own words stand beside it.
      return drawn.replace(/<desc>[^<]*<\/desc>/, "");
    });
    return { kind: "sketched", pictures, next: problem.next(plan), last };
  } finally {
    problem.free();
  }
}
