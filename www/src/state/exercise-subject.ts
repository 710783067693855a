// What an exercise asks about where its author has not said: a question that the plan shown makes no trivial one, as far
// as its steps tell. The core has the last word (`Exercise.prove`).

import type { TraceStep } from "../core.js";
import { times } from "../problem/times.js";
import type { ProblemDocument, Role } from "../problem/types.js";
import { differenceText } from "../view/numbers.js";
import { roles } from "../view/observers.js";

export const kinds = ["possible-goals", "belief", "walk", "best", "placement", "guess"] as const;
export const places = ["camera", "wall", "start"] as const;
export const variable = ["start", "goals", "walls", "true_goal", "plan"] as const;
export type Kind = (typeof kinds)[number];
export type Place = (typeof places)[number];
export type Vary = (typeof variable)[number];

/** Kinds that ask about a walk; the others ask for one. */
export const asksAboutWalk = (kind: Kind): boolean => kind !== "walk" && kind !== "best";

/** The plan on the boards. */
export interface Shown {
  document: ProblemDocument;
  steps: readonly TraceStep[];
  step: number;
  goals: readonly string[];
  trueGoal: string;
  /** The best goal difference that is known; null where none is. */
  best: number | null;
}

/** What the author chose; null: what comes of itself. */
export interface Chosen {
  kind: Kind;
  observer: Role | null;
  place: Place | null;
  goal: string | null;
  possible: boolean;
  difference: string | null;
}

export interface Subject {
  observer: Role;
  /** How many steps the question is about. */
  step: number;
  place: Place;
  goal: string;
  difference: string;
}

export function subjectOf(chosen: Chosen, shown: Shown): Subject {
  const { observer, step } = viewOf(chosen, shown);
  const offered = placesOf(shown.document);
  return {
    observer,
    step,
    place: offered.find((place) => place === chosen.place) ?? offered[0] ?? "start",
    goal: shown.goals.find((goal) => goal === chosen.goal) ?? goalOf(chosen, shown, { observer, step }),
    difference: chosen.difference ?? differenceText(shown.best ?? 0.5),
  };
}

interface View {
  observer: Role;
  step: number;
}

/** The view that is asked about: at the step shown, or, where that is the start, as late as it makes a question. */
function viewOf(chosen: Chosen, shown: Shown): View {
  const last = Math.max(0, shown.steps.length - 1);
  const backwards = times(last, (back) => last - back);
  // Who is to guess must be able to.
  const steps = chosen.kind === "guess" ? [last] : shown.step > 0 ? [shown.step] : backwards;
  const asked = chosen.observer === null ? roles : [chosen.observer];
  const views = steps.flatMap((step) => asked.map((observer) => ({ observer, step })));
  const fit = views.filter((view) => asksSomething(chosen, shown, view));
  const fallback = { observer: asked[0] ?? "adversarial", step: steps[0] ?? last };
  // Of two beliefs at a step the smaller one: the other may be everything.
  const [first = fallback, second] = fit;
  const swap = chosen.kind === "belief" && second?.step === first.step && size(shown, second) < size(shown, first);
  return swap ? second : first;
}

const size = ({ steps }: Shown, { observer, step }: View): number => steps[step]?.beliefs[observer].length ?? 0;

function asksSomething({ kind }: Chosen, shown: Shown, view: View): boolean {
  const { steps, goals, trueGoal } = shown;
  const { observer, step } = view;
  const possible = steps[step]?.goals[observer] ?? [];
  switch (kind) {
    case "possible-goals":
      return possible.length > 0 && possible.length < goals.length;
    case "belief":
      return size(shown, view) > 1;
    case "guess":
      return possible.length === 1 && possible[0] === trueGoal;
    case "placement":
      return possible.some((goal) => goal !== trueGoal);
    default:
      return true;
  }
}

/** A goal of which it is not so yet. The true one is always possible where the walk ends in it. */
function goalOf({ possible }: Chosen, { steps, goals, trueGoal }: Shown, { observer, step }: View): string {
  const now = steps[step]?.goals[observer] ?? [];
  const open = goals.filter((goal) => now.includes(goal) !== possible);
  return open.filter((goal) => goal !== trueGoal).at(-1) ?? open[0] ?? goals[0] ?? "";
}

interface Parts {
  width?: unknown;
  walls?: unknown[];
  start?: unknown;
  goals?: { cell?: unknown }[];
  problem?: unknown;
}

/** What an exercise of a document can ask. */
export const kindsOf = (document: ProblemDocument): readonly Kind[] =>
  kinds.filter((kind) =>
    kind === "placement" ? placesOf(document).length > 0 : kind === "guess" ? !tellsGoal(document) : true,
  );

/** What can be placed: formats with cells have starts and walls, and gridworlds cameras. */
export const placesOf = (document: ProblemDocument): readonly Place[] =>
  (document as Parts).width === undefined
    ? []
    : places.filter((place) => place !== "camera" || document.format === "gridworld");

/** What can differ from variant to variant. */
export function variableOf(document: ProblemDocument, kind: Kind): readonly Vary[] {
  const { width, walls = [], start, goals = [] } = document as Parts;
  const there: Record<Vary, boolean> = {
    start: width !== undefined && start !== undefined,
    goals: goals.some(({ cell }) => cell !== undefined),
    walls: walls.length > 0,
    true_goal: !tellsGoal(document),
    plan: asksAboutWalk(kind),
  };
  return variable.filter((name) => there[name]);
}

/** PDDL may name its goal, which then can be neither guessed nor another. */
const tellsGoal = (document: ProblemDocument): boolean => {
  const { problem } = document as Parts;
  return typeof problem === "string" && /\(\s*:goal\b/i.test(problem.replace(/;.*$/gm, ""));
};
