// An exercise that is being made of the open problem: what its form says, and the block that this comes to.
import { signal } from "@preact/signals-core";
import { Copier } from "../view/copier.js";

export const kinds = ["possible-goals", "belief", "walk", "best", "placement", "guess"] as const;
export const variable = ["start", "goals", "walls", "true_goal", "plan"] as const;
type Kind = (typeof kinds)[number];

/** What the form says; texts as they were typed. */
export interface DraftFields {
  kind: Kind;
  title: string;
  introduction: string;
  observer: "adversarial" | "cooperative";
  place: "camera" | "wall" | "start";
  goal: string;
  possible: boolean;
  difference: string;
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
  observer: "adversarial",
  place: "camera",
  goal: "",
  possible: false,
  difference: "0.5",
  atMost: "",
  shortest: false,
  hints: "",
  attempts: "",
  hidesBeliefs: null,
  lock: true,
  lockedKeys: [],
  vary: [],
};

/** What observers believe would give the answer away, where the question is about a walk that is told. */
export const hidesBeliefs = ({ kind, hidesBeliefs }: DraftFields): boolean => hidesBeliefs ?? asksAboutWalk(kind);

/** Kinds that ask about a walk; the others ask for one. */
export const asksAboutWalk = (kind: Kind): boolean => kind !== "walk" && kind !== "best";

export class ExerciseDraft {
  readonly fields = signal<DraftFields>(empty);
  readonly copier = new Copier();
  /** A text to copy by hand, where the page may not use the clipboard. */
  readonly shown = signal("");
  /** Why there is nothing to hand out: the core's word of what is wrong. */
  readonly fault = signal("");
  /** Goes back to what was being edited when its exercise was tried. */
  readonly tried = signal<(() => void) | null>(null);

  edit(change: Partial<DraftFields>): void {
    this.fields.value = { ...this.fields.value, ...change };
    this.shown.value = "";
    this.fault.value = "";
  }

  /** The block; `plan` is the walk shown, `goal` a goal to ask about where none is chosen. */
  block(plan: readonly string[], goal: string): object {
    const { kind, title, introduction, hints, attempts, lock, lockedKeys, vary, ...rest } = this.fields.value;
    const lines = hints.split("\n").map((line) => line.trim());
    return {
      kind,
      ...(title.trim() === "" ? {} : { title: title.trim() }),
      ...(introduction.trim() === "" ? {} : { introduction: introduction.trim() }),
      ...(asksAboutWalk(kind) ? { observer: rest.observer, plan } : {}),
      ...(kind === "placement"
        ? { place: rest.place, goal: rest.goal === "" ? goal : rest.goal, possible: rest.possible }
        : {}),
      ...(kind === "walk"
        ? { ...numberAs("goal_difference", rest.difference), ...numberAs("at_most", rest.atMost) }
        : {}),
      ...(kind === "best" && rest.shortest ? { shortest: true } : {}),
      ...(lines.some((line) => line !== "") ? { hints: lines.filter((line) => line !== "") } : {}),
      ...numberAs("attempts", attempts),
      ...(hidesBeliefs(this.fields.value) === asksAboutWalk(kind)
        ? {}
        : { hide: asksAboutWalk(kind) ? [] : ["beliefs"] }),
      ...(lock ? {} : { lock: lockedKeys.length === 0 ? false : lockedKeys }),
      ...(vary.length === 0 ? {} : { vary: vary.filter((name) => name !== "plan" || asksAboutWalk(kind)) }),
    };
  }
}

/** What is no number goes to the core as it was typed: it has the words for it. */
function numberAs(key: string, text: string): object {
  if (text.trim() === "") return {};
  // A decimal comma is one.
  const number = Number(text.trim().replace(/^(\d+),(\d+)$/, "$1.$2"));
  return { [key]: Number.isFinite(number) ? number : text };
}
