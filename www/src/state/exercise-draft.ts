// An exercise that is being made of the open problem: what its form says, and the block that this comes to.
import { effect, signal } from "@preact/signals-core";
import type { ProblemDocument } from "../problem/types.js";
import { Copier } from "../view/copier.js";
import type { Proof } from "./exercise.js";
import { asksAboutWalk, type Chosen, kindsOf, type Shown, subjectOf, variableOf } from "./exercise-subject.js";
import { differenceIn } from "./goal-difference-text.js";
import { KeptDraft } from "./kept-draft.js";
import type { OpenProblem } from "./open-problem.js";
import type { Workbench } from "./workbench.js";

/** What the form says; texts as they were typed. */
export interface DraftFields extends Chosen {
  title: string;
  introduction: string;
  atMost: string;
  shortest: boolean;
  /** One a line. */
  hints: string;
  attempts: string;
  /** Null: where it would give the answer away. */
  hidesBeliefs: boolean | null;
  lock: boolean;
  /** Keys of the document that stay as they are where the problem may be opened. */
  lockedKeys: readonly string[];
  vary: readonly string[];
}

const empty: DraftFields = {
  kind: "possible-goals",
  title: "",
  introduction: "",
  observer: null,
  place: null,
  goal: null,
  possible: false,
  difference: null,
  atMost: "",
  shortest: false,
  hints: "",
  attempts: "",
  hidesBeliefs: null,
  lock: true,
  lockedKeys: [],
  vary: [],
};

/** The fields of a form that was kept; what does not read like one is as in a new form. */
function fieldsIn(text: string): DraftFields {
  const kept: Record<string, unknown> = { ...empty, ...parsed(text) };
  const fits = Object.entries(empty).every(([name, value]) => {
    const other = kept[name];
    if (Array.isArray(value)) return Array.isArray(other) && other.every((one) => typeof one === "string");
    return value === null ? other === null || typeof other !== "object" : typeof other === typeof value;
  });
  return fits ? (kept as unknown as DraftFields) : empty;
}

function parsed(text: string): object {
  try {
    return Object(JSON.parse(text));
  } catch {
    return {};
  }
}

/** What observers believe would give the answer away, where the question is about a walk that is told. */
export const hidesBeliefs = ({ kind, hidesBeliefs }: DraftFields): boolean => hidesBeliefs ?? asksAboutWalk(kind);

/** What the core says of an exercise that was to be handed out. */
export interface Objection extends Proof {
  /** The document that it is about. */
  text: string;
}

export class ExerciseDraft {
  readonly fields = signal<DraftFields>(empty);
  readonly copier = new Copier();
  /** A text to copy by hand, where the page may not use the clipboard. */
  readonly shown = signal("");
  /** Why nothing was handed out. What is only trivial is handed out when it is asked for again. */
  readonly objection = signal<Objection | null>(null);
  /** The text of the exercise that is being tried, the state of what was being edited, and how to go back to it. */
  readonly tried = signal<{ text: string; before: string | null; back: () => void } | null>(null);

  private readonly kept: KeptDraft;
  /** Whether what was kept was looked for: there is a document that it may belong to. */
  private begun = false;

  constructor({ problem, workbench }: { problem: Pick<OpenProblem, "document">; workbench: Pick<Workbench, "id"> }) {
    this.kept = new KeptDraft(`${workbench.id} exercise`);
    effect(() => {
      const from = problem.document.value?.text;
      if (from === undefined) return;
      if (!this.begun) {
        this.begun = true;
        const before = this.kept.read(from);
        if (before !== null && this.fields.value === empty) this.fields.value = fieldsIn(before.text);
      }
      this.kept.listen();
      const { value } = this.fields;
      // What was begun for another document stays kept while this form is untouched.
      if (value !== empty) this.kept.write({ text: JSON.stringify(value), from });
    });
  }

  sleep(): void {
    this.kept.release();
  }

  wake(): void {
    if (this.begun) this.kept.listen();
  }

  edit(change: Partial<DraftFields>): void {
    this.fields.value = { ...this.fields.value, ...change };
    this.shown.value = "";
    this.objection.value = null;
  }

  /** The fields, as far as they fit a document: a kind that it cannot have is the first. */
  fitting(document: ProblemDocument): DraftFields {
    const fields = this.fields.value;
    const kind = kindsOf(document).find((kind) => kind === fields.kind) ?? "possible-goals";
    const vary = variableOf(document, kind).filter((name) => fields.vary.includes(name));
    return { ...fields, kind, vary };
  }

  /** The block of an exercise of the plan shown. */
  block(shown: Shown): object {
    const fields = this.fitting(shown.document);
    const { kind, title, introduction, hints, attempts, lock, lockedKeys, vary, ...rest } = fields;
    const { observer, step, place, goal, difference } = subjectOf(fields, shown);
    const plan = shown.steps.slice(1, step + 1).flatMap(({ action }) => (action === null ? [] : [action]));
    const lines = hints.split("\n").map((line) => line.trim());
    return {
      kind,
      ...(title.trim() === "" ? {} : { title: title.trim() }),
      ...(introduction.trim() === "" ? {} : { introduction: introduction.trim() }),
      ...(asksAboutWalk(kind) ? { observer, plan } : {}),
      ...(kind === "placement" ? { place, goal, possible: rest.possible } : {}),
      ...(kind === "walk"
        ? { ...differenceAs(difference, shown.goals.length), ...numberAs("at_most", rest.atMost) }
        : {}),
      ...(kind === "best" && rest.shortest ? { shortest: true } : {}),
      ...(lines.some((line) => line !== "") ? { hints: lines.filter((line) => line !== "") } : {}),
      ...numberAs("attempts", attempts),
      ...(hidesBeliefs(fields) === asksAboutWalk(kind) ? {} : { hide: asksAboutWalk(kind) ? [] : ["beliefs"] }),
      ...(lock ? {} : { lock: lockedKeys.length === 0 ? false : lockedKeys }),
      ...(vary.length === 0 ? {} : { vary }),
    };
  }
}

/** The exact number: one that is rounded up no walk would reach. */
const differenceAs = (text: string, goals: number): object =>
  text.trim() === "" ? {} : { goal_difference: differenceIn(text, goals) ?? text };

/** What is no number goes to the core as it was typed: it has the words for it. */
function numberAs(key: string, text: string): object {
  if (text.trim() === "") return {};
  // A decimal comma is one.
  const number = Number(text.trim().replace(/^(\d+),(\d+)$/, "$1.$2"));
  return { [key]: Number.isFinite(number) ? number : text };
}
