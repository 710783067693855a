// The problem that is open: its document as the core took it, the edits on their way to the core, and what was there
// before them.
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Scene } from "../core.js";
import type { ProblemDocument } from "../problem/types.js";
import { History } from "./history.js";
import type { KeptAnswer } from "./kept-answer.js";
import { hidesBeliefs } from "./locks.js";

/** The question that a problem belongs to, while it is open without it. */
export interface LeftQuestion {
  /** The text of the document with the exercise. */
  document: string;
  answer: KeptAnswer;
  /** Keys of the document that no edit may change. */
  locked: readonly string[];
}

export interface OpenDocument {
  text: string;
  value: ProblemDocument;
  question?: LeftQuestion;
  /** Solvers and best values are kept back: the question that the problem belongs to is still to be answered. */
  closed?: true;
}

export class OpenProblem {
  /** The document that is open; what is drawn comes from it. */
  readonly document = signal<OpenDocument | null>(null);
  readonly scene = signal<Scene | null>(null);
  /** The document as it was opened, before any edit. */
  readonly origin = signal<OpenDocument | null>(null);
  /** The text of a document that is being opened: it is shown before it is solved. */
  readonly opening = signal<string | null>(null);
  readonly question: ReadonlySignal<LeftQuestion | null> = computed(() => this.document.value?.question ?? null);
  readonly closed: ReadonlySignal<boolean> = computed(() => this.document.value?.closed === true);
  /** What observers believe is not shown: the question hides it and is still to be answered. */
  readonly veiled: ReadonlySignal<boolean> = computed(() => {
    const question = this.question.value;
    return this.closed.value && question !== null && hidesBeliefs(question.document);
  });
  readonly history = new History<OpenDocument>();
  readonly canReset: ReadonlySignal<boolean> = computed(() => {
    const text = this.document.value?.text;
    return this.origin.value !== null && text !== this.origin.value.text && text !== this.opening.value;
  });

  /** The newest document that was asked for, while the core has not said whether it is right. */
  private wanted: OpenDocument | null = null;
  /** Puts the history back as it was while this document was on the page, should the change from it come to nothing. */
  private kept: { document: OpenDocument | null; putBack: () => void } | null = null;

  /** The document that the next edit starts from, and that the next solve is about. */
  get newest(): OpenDocument | null {
    return this.wanted ?? this.document.value;
  }

  /** Which of these keys of the document no edit may change. */
  lockedAmong(keys: readonly string[]): string[] {
    const locked = this.newest?.question?.locked ?? [];
    return keys.filter((key) => locked.includes(key));
  }

  get latest(): ProblemDocument | null {
    return this.newest?.value ?? null;
  }

  want(document: OpenDocument): void {
    this.wanted = document;
  }

  /** The core took a document. False where it is the one that was open before. */
  take(document: OpenDocument, scene: Scene): boolean {
    if (this.wanted === document) this.wanted = null;
    if (this.document.value === document) return false;
    this.document.value = document;
    this.scene.value = scene;
    return true;
  }

  /** The core did not take what was asked for: nothing has changed. */
  giveUp(): void {
    this.wanted = null;
    const present = this.document.value;
    if (this.kept?.document === present) this.kept?.putBack();
    else if (present !== null) this.history.forget(present);
    this.kept = null;
  }

  /** An edit was made to `before`: it can be undone. */
  record(before: OpenDocument): void {
    if (before === this.document.value) this.keepHistory();
    this.history.record(before);
  }

  /** The document that undo or redo leads to. */
  travel(way: "undo" | "redo"): OpenDocument | undefined {
    const present = this.newest;
    this.keepHistory();
    return present === null ? undefined : this.history[way](present);
  }

  private keepHistory(): void {
    const document = this.document.value;
    if (this.kept?.document !== document) this.kept = { document, putBack: this.history.keep() };
  }
}
