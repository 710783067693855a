// Documents come and go: opening, editing with the best plan following, undoing.
import type { Signal } from "@preact/signals-core";
import { written } from "../problem/text.js";
import type { ProblemDocument } from "../problem/types.js";
import type { Answer } from "./answer.js";
import type { Editing } from "./editing.js";
import type { Exercise } from "./exercise.js";
import { emptyForm, exactOptions, type Form, optionsOf } from "./form.js";
import { asksGoal } from "./locks.js";
import type { LeftQuestion, OpenDocument, OpenProblem } from "./open-problem.js";
import type { Solving } from "./solving.js";

interface Stores {
  problem: OpenProblem;
  answer: Pick<Answer, "again" | "dismiss" | "ran">;
  editing: Pick<Editing, "drag">;
  exercise: Pick<
    Exercise,
    "block" | "close" | "foundGoal" | "kept" | "open" | "posed" | "resume" | "standing" | "stopOpening" | "textOf"
  >;
  form: Signal<Form>;
  solving: Pick<Solving, "clear" | "follow" | "open" | "refuse">;
}

export class Edits {
  /** The document before the edit under way. */
  private before: OpenDocument | null = null;
  /** How many documents were asked for: one that comes late is behind a question that was asked for after it. */
  private asked = 0;

  constructor(private readonly stores: Stores) {}

  /**
   * Opens a document and solves it: exactly, or with the solver chosen. One that can't be read leaves everything as it
   * was. `at`: a problem that was not seen yet begins at its first step. A document with an exercise is asked and not
   * solved. `left`: the question that it belongs to.
   */
  async open(
    text: string,
    form: Partial<Form> = {},
    solver: "exact" | "chosen" = "exact",
    at: "first" | "end" = "end",
    left: LeftQuestion | null = null,
  ): Promise<boolean> {
    const { problem, answer, editing, form: asked, solving, exercise } = this.stores;
    const again = () => void this.open(text, form, solver, at, left);
    this.asked += 1;
    const now = this.asked;
    const question = left === null ? exercise.textOf(text) : null;
    if (question !== null) {
      const refused = await exercise.open(question);
      if (refused !== null) solving.refuse(refused.message, refused.missing ? again : null);
      // What was said of another document is over.
      else answer.dismiss();
      return refused === null;
    }
    const guessed = left !== null && asksGoal(left.document);
    const standing =
      left !== null && (guessed || left.locked.length > 0) ? await exercise.standing(left.document, left.answer) : null;
    if (now !== this.asked) return false;
    // Its true goal is still to be found: what the problem has in its place must not be taken for it.
    if (guessed && standing !== "right") return this.askAgain(left);
    // Where parts are locked the solvers are, too, until the question is over.
    const closed = standing === "asked";
    // A question on its way would come over it; the one that is open stays until there is something else.
    exercise.stopOpening();
    // What is being dragged belongs to the problem that was open.
    editing.drag.value = null;
    const document = { text, value: documentIn(text), ...belonging(left ?? undefined, closed) };
    const before = problem.document.value;
    const asking = asked.value;
    const fitting = { ...emptyForm, solver: asking.solver, encoding: asking.encoding, ...form };
    asked.value = fitting;
    solving.clear();
    this.before = null;
    problem.want(document);
    const exact = exactOptions(fitting);
    const options = solver === "exact" ? exact : optionsOf(fitting);
    if (typeof options === "string" || typeof exact === "string") {
      solving.refuse(typeof options === "string" ? options : String(exact));
      return false;
    }
    problem.opening.value = text;
    await solving.open(document, options, exact, at);
    if (problem.document.value === document) {
      problem.origin.value = document;
      // What was open before is no way around a lock, nor one back to the problem of a question.
      if (left !== (before?.question ?? null)) problem.history.clear();
      else if (before !== null && before.text !== text) problem.history.record(before);
      // The problem is open without its question.
      if (left !== null) exercise.block = null;
      if (now === this.asked) exercise.close();
    }
    if (problem.opening.value === text) problem.opening.value = null;
    if (problem.document.value !== document) {
      // Another document may have been asked for meanwhile, with a form of its own.
      if (asked.value === fitting && problem.document.value === before) asked.value = asking;
      if (answer.again.value !== null) answer.again.value = again;
      return false;
    }
    answer.ran.value = solver === "exact" ? null : options.solver;
    return true;
  }

  /** Opens the problem of the exercise that is asked without its question. */
  async leaveExercise(): Promise<void> {
    const { exercise } = this.stores;
    const posed = exercise.posed.value;
    if (posed === null) return;
    const { lock, document, kind } = posed.question;
    const goal = exercise.foundGoal.value;
    if (kind === "guess" && goal === null) return;
    const problem = goal === null ? document : { ...document, true_goal: goal };
    const left = { document: posed.text, answer: exercise.kept, locked: typeof lock === "boolean" ? [] : lock };
    await this.open(JSON.stringify(problem, null, 2), {}, "exact", "end", left);
  }

  /** Asks the question again that the open problem belongs to. */
  async returnToExercise(): Promise<void> {
    const left = this.stores.problem.question.value;
    if (left !== null) await this.askAgain(left);
  }

  private async askAgain({ document, answer }: LeftQuestion): Promise<boolean> {
    const asked = await this.open(document);
    if (asked) await this.stores.exercise.resume(answer);
    return asked;
  }

  /** Opens a text that was written in place of the open problem's: what is locked stays as it was. */
  async rewrite(text: string): Promise<boolean> {
    const { problem, solving } = this.stores;
    const refused = this.forbids(documentIn(text));
    if (refused === null) return this.open(text, {}, "exact", "end", problem.question.value);
    solving.refuse(refused);
    return false;
  }

  /** Why an edit may not be made; null where it may. */
  forbids(value: object): string | null {
    const { problem } = this.stores;
    const before = this.before ?? problem.newest;
    const changed = before?.question?.locked.find(
      (key) => JSON.stringify(part(before.value, key)) !== JSON.stringify(part(value, key)),
    );
    return changed === undefined
      ? null
      : `“${changed}” stays as the exercise has it: this part of the problem is locked.`;
  }

  /** Shows an edit with its best plan while it is being made: while something is dragged, say. */
  preview(value: ProblemDocument): void {
    const refused = this.forbids(value);
    if (refused !== null) {
      this.stores.solving.refuse(refused);
      return;
    }
    this.before ??= this.stores.problem.newest;
    const { question, closed } = this.before ?? {};
    this.follow({ value, text: written(value), ...belonging(question, closed) });
  }

  /** The edit is made: it can be undone. */
  commit(): void {
    const { problem } = this.stores;
    if (this.before !== null && this.before.text !== problem.newest?.text) problem.record(this.before);
    this.before = null;
  }

  /** The edit that is being made is given up: everything is as it was before. */
  takeBack(): void {
    const before = this.before;
    this.before = null;
    if (before !== null) this.follow(before);
  }

  /** Makes an edit at once. */
  apply(value: ProblemDocument): void {
    this.preview(value);
    this.commit();
  }

  undo(): void {
    this.travel("undo");
  }

  redo(): void {
    this.travel("redo");
  }

  /** Takes every edit back; that, too, can be undone. */
  reset(): void {
    const origin = this.stores.problem.origin.value;
    if (origin !== null) this.apply(origin.value);
  }

  private travel(way: "undo" | "redo"): void {
    const target = this.stores.problem.travel(way);
    if (target === undefined) return;
    this.before = null;
    this.follow(target);
  }

  private follow(document: OpenDocument): void {
    this.stores.problem.want(document);
    this.stores.solving.follow(document);
  }
}

/** What a document has of the question that it belongs to. */
const belonging = (question?: LeftQuestion, closed = false): Pick<OpenDocument, "closed" | "question"> => ({
  ...(question === undefined ? {} : { question }),
  ...(closed ? { closed } : {}),
});

const part = (document: object, key: string): unknown => (document as Record<string, unknown>)[key] ?? null;

function documentIn(text: string): ProblemDocument {
  try {
    return JSON.parse(text);
  } catch {
    // The core has the better words for it: let it refuse the text.
    return { format: "explicit" };
  }
}
