// What a link holds: the problem, what is asked of the solver, the plan shown and the step, and what is open.

import type { ReadonlySignal } from "@preact/signals-core";
import { written } from "../problem/text.js";
import type { Answer } from "../state/answer.js";
import type { Boards, Mode } from "../state/boards.js";
import { type Comparison, initialPatience, patiences } from "../state/comparison.js";
import type { Exercise } from "../state/exercise.js";
import type { ExerciseDraft } from "../state/exercise-draft.js";
import { emptyForm, type Form, optionsOf, solverNames } from "../state/form.js";
import type { Guess } from "../state/guess.js";
import { type KeptAnswer, readAnswer } from "../state/kept-answer.js";
import type { LeftQuestion, OpenDocument, OpenProblem } from "../state/open-problem.js";
import type { Timeline } from "../state/timeline.js";
import { extras, initialExtra, type Tradeoff } from "../state/tradeoff.js";
import type { Workbench } from "../state/workbench.js";
import { LinkError } from "./packed.js";

export interface SharedStores {
  problem: OpenProblem;
  boards: Boards;
  timeline: Timeline;
  answer: Answer;
  form: ReadonlySignal<Form>;
  guess: Guess;
  comparison: Comparison;
  tradeoff: Tradeoff;
  workbench: Workbench;
  exercise: Pick<Exercise, "posed" | "kept">;
}

export interface SharedState {
  /** The document's text, as it is. */
  document: string;
  form: Partial<Form>;
  /** The answer was that of the solver chosen, not of the exact search that goes before it: it is asked for again. */
  answered?: true;
  /** The actions that are shown; left out while the enemy's player must not know them. */
  plan?: string[];
  /** Whose plan it is, where it is not the solver's. */
  title?: string;
  step: number;
  tab: string;
  mode: Mode;
  /** How many moves more than the shortest plan the trade-off looks at, where somebody chose it. */
  extra?: number;
  /** The answer to an exercise: the document is one then. */
  answer?: KeptAnswer;
  /** The question that the problem belongs to, where it is open without it. */
  question?: LeftQuestion;
  /** The seconds that each solver of the comparison may take, where somebody chose them; 0: without end. */
  patience?: number;
}

export interface TriedStores {
  exerciseDraft: Pick<ExerciseDraft, "tried">;
}

/** The core takes no longer plans. */
const LONGEST_PLAN = 10_000;
const LONGEST_TITLE = 120;
/** No document has as many keys. */
const MOST_LOCKED = 100;

export function stateOf(playground: SharedStores): SharedState | null {
  const posed = playground.exercise.posed.value;
  if (posed !== null) {
    return { document: posed.text, form: {}, step: 0, tab: "", mode: "plan", answer: playground.exercise.kept };
  }
  const document = playground.problem.document.value;
  if (document === null) return null;
  const { timeline } = playground;
  const mode = playground.boards.mode.value;
  const plan = mode === "guess" ? [] : planShown(playground);
  const title = playground.boards.chosen.value;
  const extra = playground.tradeoff.extra.value;
  const patience = playground.comparison.patience.value;
  return {
    document: documentShown(playground, document),
    form: changed(playground.form.value),
    ...(answered(playground) ? { answered: true } : {}),
    ...(plan.length > 0 ? { plan } : {}),
    ...(title !== null ? { title } : {}),
    step: timeline.step.value,
    tab: playground.workbench.tab.value,
    mode,
    ...(extra === initialExtra ? {} : { extra }),
    ...(document.question === undefined ? {} : { question: document.question }),
    ...(patience === initialPatience ? {} : { patience: Number.isFinite(patience) ? patience : 0 }),
  };
}

/** The state to come back to, as text: while an exercise is tried by its author, that of the editing. */
export function keptState(playground: SharedStores & TriedStores): string | null {
  const state = stateOf(playground);
  const tried = playground.exerciseDraft.tried.value;
  if (state === null || tried === null) return state === null ? null : JSON.stringify(state);
  if (playground.exercise.posed.value?.text === tried.text) return tried.before;
  // Its problem without the question is no way to one that counts.
  const { question, ...problem } = state;
  return JSON.stringify(question?.document === tried.text ? problem : state);
}

/** After a guess the steps are those of the goal that was drawn for it: so is the document of the link. */
function documentShown({ guess, boards: { mode, chosen } }: SharedStores, { text, value }: OpenDocument): string {
  const round = guess.round.value;
  const drawn = round.kind === "over" && mode.value === "plan" && chosen.value === null;
  if (!drawn || round.goal === (value as { true_goal?: string }).true_goal) return text;
  return written({ ...value, true_goal: round.goal } as typeof value);
}

export function planShown({ timeline }: Pick<SharedStores, "timeline">): string[] {
  const steps = timeline.trace.value?.steps.slice(1) ?? [];
  return steps.flatMap(({ action }) => (action === null ? [] : [action]));
}

function answered({ form, answer: { result } }: SharedStores): boolean {
  const options = result.value?.options;
  return (
    options !== undefined &&
    options.solver !== "exact" &&
    JSON.stringify(options) === JSON.stringify(optionsOf(form.value))
  );
}

/** What differs from a form that nobody touched. */
function changed(form: Form): Partial<Form> {
  const initial: Record<string, string> = { ...emptyForm };
  return Object.fromEntries(Object.entries(form).filter(([field, value]) => value !== initial[field]));
}

/** Reads what a link held. Whoever made it, nothing of a wrong type gets through. */
export function readState(text: string): SharedState {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    throw new LinkError("This link is damaged.");
  }
  if (typeof value !== "object" || value === null) throw new LinkError("This link is damaged.");
  const { document, form, answered, plan, title, step, tab, mode, extra, patience, answer, question } = value as Record<
    string,
    unknown
  >;
  if (typeof document !== "string") throw new LinkError("This link is damaged: it holds no problem.");
  const kept = readAnswer(answer);
  const left = readQuestion(question);
  return {
    document,
    form: readForm(form),
    ...(answered === true ? { answered } : {}),
    ...(isPlan(plan) ? { plan } : {}),
    ...(typeof title === "string" && title.length <= LONGEST_TITLE ? { title } : {}),
    step: typeof step === "number" && Number.isInteger(step) ? step : 0,
    tab: typeof tab === "string" ? tab : "",
    mode: mode === "walk" || mode === "guess" ? mode : "plan",
    ...(isOneOf(extras, extra) ? { extra } : {}),
    ...(isOneOf([0, ...patiences], patience) ? { patience } : {}),
    ...(kept === null ? {} : { answer: kept }),
    ...(left === null ? {} : { question: left }),
  };
}

function readQuestion(value: unknown): LeftQuestion | null {
  if (typeof value !== "object" || value === null) return null;
  const { document, answer, locked } = value as Record<string, unknown>;
  const kept = readAnswer(answer);
  const keys = Array.isArray(locked) && locked.length <= MOST_LOCKED && locked.every((key) => typeof key === "string");
  return typeof document === "string" && kept !== null && keys ? { document, answer: kept, locked } : null;
}

const isOneOf = (numbers: readonly number[], value: unknown): value is number => numbers.some((one) => one === value);

const isPlan = (value: unknown): value is string[] =>
  Array.isArray(value) && value.length <= LONGEST_PLAN && value.every((action) => typeof action === "string");

function readForm(value: unknown): Partial<Form> {
  if (typeof value !== "object" || value === null) return {};
  const known = Object.entries(value).filter(
    ([field, text]) => Object.hasOwn(emptyForm, field) && typeof text === "string" && allowed(field, text),
  );
  return Object.fromEntries(known);
}

function allowed(field: string, text: string): boolean {
  if (field === "solver") return solverNames.some((name) => name === text);
  if (field === "encoding") return text === "paper" || text === "belief-flow";
  return /^\d{0,6}$/.test(text);
}
