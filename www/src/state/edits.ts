// Documents come and go: opening, editing with the best plan following, undoing.
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import { written } from "../problem/text.js";
import type { ProblemDocument } from "../problem/types.js";
import { emptyForm, exactOptions, type Form, optionsOf } from "./form.js";
import { History } from "./history.js";
import type { OpenDocument } from "./result.js";
import { Session } from "./session.js";

export abstract class Edits extends Session {
  readonly history = new History<OpenDocument>();
  readonly canReset: ReadonlySignal<boolean> = computed(() => {
    const text = this.document.value?.text;
    return this.origin.value !== null && text !== this.origin.value.text && text !== this.opening.value;
  });

  /** The document as it was opened, before any edit. */
  readonly origin = signal<OpenDocument | null>(null);
  /** The text of a document that is being opened: it is shown before it is solved. */
  private readonly opening = signal<string | null>(null);
  /** The document before the edit under way. */
  private before: OpenDocument | null = null;

  /** Puts the history back as it was while this document was on the page, should the change from it come to nothing. */
  private kept: { document: OpenDocument | null; putBack: () => void } | null = null;

  /** What the next edit starts from. */
  get latest(): ProblemDocument | null {
    return (this.wanted ?? this.document.value)?.value ?? null;
  }

  /**
   * Opens a document and solves it: exactly, or with the solver chosen. One that can't be read leaves everything as it
   * was.
   */
  async open(text: string, form: Partial<Form> = {}, solver: "exact" | "chosen" = "exact"): Promise<boolean> {
    let value: ProblemDocument;
    try {
      value = JSON.parse(text);
    } catch {
      // The core has the better words for it: let it refuse the text.
      value = { format: "explicit" };
    }
    const document = { text, value };
    const before = this.document.value;
    const asked = this.form.value;
    const fitting = { ...emptyForm, solver: asked.solver, encoding: asked.encoding, ...form };
    this.form.value = fitting;
    this.live.clear();
    this.before = null;
    this.wanted = document;
    const exact = exactOptions(fitting);
    const options = solver === "exact" ? exact : optionsOf(fitting);
    if (typeof options === "string") {
      this.refuse(options);
      return false;
    }
    this.asked = JSON.stringify(exact);
    this.begin();
    this.opening.value = text;
    await this.perform({ document, options, at: "end" });
    if (this.document.value === document) this.origin.value = document;
    if (this.opening.value === text) this.opening.value = null;
    if (this.document.value !== document) {
      // Another document may have been asked for meanwhile, with a form of its own.
      if (this.form.value === fitting && this.document.value === before) this.form.value = asked;
      return false;
    }
    if (before !== null && before.text !== text) this.history.record(before);
    this.ran.value = solver === "exact" ? null : options.solver;
    return true;
  }

  /** Shows an edit with its best plan while it is being made: while something is dragged, say. */
  preview(value: ProblemDocument): void {
    this.before ??= this.wanted ?? this.document.value;
    this.wanted = { value, text: written(value) };
    this.solveLive(this.wanted);
  }

  /** The edit is made: it can be undone. */
  commit(): void {
    if (this.before !== null && this.before.text !== (this.wanted ?? this.document.value)?.text) {
      if (this.before === this.document.value) this.keepHistory();
      this.history.record(this.before);
    }
    this.before = null;
  }

  /** The edit that is being made is given up: everything is as it was before. */
  takeBack(): void {
    const before = this.before;
    this.before = null;
    if (before === null) return;
    this.wanted = before;
    this.solveLive(before);
  }

  /** Makes an edit at once. */
  apply(value: ProblemDocument): void {
    this.preview(value);
    this.commit();
  }

  undo(): void {
    this.travel((present) => this.history.undo(present));
  }

  redo(): void {
    this.travel((present) => this.history.redo(present));
  }

  /** Takes every edit back; that, too, can be undone. */
  reset(): void {
    if (this.origin.value !== null) this.apply(this.origin.value.value);
  }

  protected override editRefused(): void {
    const present = this.document.value;
    if (this.kept?.document === present) this.kept?.putBack();
    else if (present !== null) this.history.forget(present);
    this.kept = null;
  }

  private keepHistory(): void {
    const document = this.document.value;
    if (this.kept?.document !== document) this.kept = { document, putBack: this.history.keep() };
  }

  private travel(step: (present: OpenDocument) => OpenDocument | undefined): void {
    const present = this.wanted ?? this.document.value;
    this.keepHistory();
    const target = present === null ? undefined : step(present);
    if (target === undefined) return;
    this.before = null;
    this.wanted = target;
    this.solveLive(target);
  }
}
