// The playground's state, all in one place, and what can be done to it. Views read the signals and call the actions.
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { NextAction, Outcome, Progress, Scene, SolveOptions, Trace } from "../core.js";
import { Gallery } from "../gallery/gallery.js";
import { written } from "../problem/text.js";
import type { ProblemDocument } from "../problem/types.js";
import { Draft } from "../share/draft.js";
import { type Ending, SolverClient } from "../worker/client.js";
import type { Answered, Update } from "../worker/protocol.js";
import { Adviser } from "./adviser.js";
import { Coalesce } from "./coalesce.js";
import { Comparison } from "./comparison.js";
import { Editing } from "./editing.js";
import { emptyForm, exactOptions, type Form, optionsOf } from "./form.js";
import { GoalStory } from "./goal-story.js";
import { Guess } from "./guess.js";
import { History } from "./history.js";
import { Drafts, fitted } from "./numbers.js";
import { Stopwatch } from "./stopwatch.js";
import { Timeline } from "./timeline.js";
import { Tradeoff } from "./tradeoff.js";
import { Walk } from "./walk.js";
import { Workbench } from "./workbench.js";

export type Status = "idle" | "solving" | "error" | Outcome["status"];

/** Whose steps are shown: a plan's, or those of the person who walks, or those that the person sees as the enemy. */
export type Mode = "plan" | "walk" | "guess";

export interface OpenDocument {
  text: string;
  value: ProblemDocument;
}

/** What a solve was asked and answered. */
export interface Result {
  options: SolveOptions;
  outcome: Answered;
}

interface Job {
  document: OpenDocument;
  options: SolveOptions;
  /** Which step to show then. */
  at: "start" | "end" | "same";
}

export class Playground {
  /** The document that is open; what is drawn comes from it. */
  readonly document = signal<OpenDocument | null>(null);
  readonly scene = signal<Scene | null>(null);
  readonly result = signal<Result | null>(null);
  /** The exact answer for the document that is open, whatever was solved since. */
  readonly optimum = signal<Result | null>(null);
  readonly status = signal<Status>("idle");
  /** Solving takes so long that it should be seen. */
  readonly slow = signal(false);
  readonly error = signal<string | null>(null);
  readonly progress = signal<Progress | null>(null);
  readonly form = signal<Form>(emptyForm);
  readonly mode = signal<Mode>("plan");
  /** What the plan shown is, where it is not the result: "a plan of the trade-off". */
  readonly chosen = signal<string | null>(null);
  readonly timeline = new Timeline();
  readonly history = new History<OpenDocument>();
  /** The solver that was run by hand last, on this problem or on what it was edited from. */
  readonly ran = signal<Form["solver"] | null>(null);
  readonly workbench = new Workbench();
  readonly story = new GoalStory(this.timeline);
  readonly walker = new Walk(this);
  readonly guess = new Guess(this);
  readonly drafts = new Drafts();
  readonly adviser = new Adviser(this);
  readonly comparison = new Comparison(this);
  readonly tradeoff = new Tradeoff(this);
  /** How long the solver has been at work. */
  readonly stopwatch = new Stopwatch();
  readonly editing = new Editing();
  readonly gallery = new Gallery(this);
  readonly draft = new Draft(this);

  /** The goal difference at the end of the plan shown; null while there is none. */
  readonly difference: ReadonlySignal<number | null> = computed(() => {
    if (this.mode.value === "guess") return null;
    const trace = this.timeline.trace.value;
    return trace?.valid && this.hasPlan.value ? trace.goal_difference : null;
  });
  readonly canReset: ReadonlySignal<boolean> = computed(
    () => this.origin.value !== null && this.origin.value.text !== this.document.value?.text,
  );

  private readonly hasPlan = signal(false);
  /** The steps of the result, to come back to. */
  private resultTrace: Trace | null = null;
  /** The document as it was opened, before any edit. */
  private readonly origin = signal<OpenDocument | null>(null);
  /** The newest document that was asked for, while the core has not said whether it is right. */
  private wanted: OpenDocument | null = null;
  /** The document before the edit under way. */
  private before: OpenDocument | null = null;
  /** What the best possible was asked for last. */
  private asked = "";
  private readonly live = new Coalesce<Job>((job) => this.perform(job));

  /** For short questions while the other solves. */
  private readonly aside = new SolverClient();

  constructor(private readonly client: SolverClient) {}

  /** What the next edit starts from. */
  get latest(): ProblemDocument | null {
    return (this.wanted ?? this.document.value)?.value ?? null;
  }

  /** Opens a document and solves it. One that can't be read leaves everything as it was. */
  async open(text: string, form: Partial<Form> = {}): Promise<boolean> {
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
    this.form.value = { ...emptyForm, solver: asked.solver, encoding: asked.encoding, ...form };
    this.live.clear();
    this.before = null;
    this.wanted = document;
    const options = exactOptions(this.form.value);
    if (typeof options === "string") {
      this.refuse(options);
      return false;
    }
    this.asked = JSON.stringify(options);
    this.begin();
    await this.perform({ document, options, at: "end" });
    if (this.document.value !== document) {
      if (this.document.value === before) this.form.value = asked;
      return false;
    }
    if (before !== null && before.text !== text) this.history.record(before);
    this.origin.value = document;
    this.ran.value = null;
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

  /**
   * Changes what is asked of the solver. The best possible follows at once, whatever the solver: what it is depends on
   * the bounds.
   */
  edit(change: Partial<Form>): void {
    this.form.value = { ...this.form.value, ...change };
    const document = this.wanted ?? this.document.value;
    const asked = JSON.stringify(exactOptions(this.form.value));
    const wanted = this.form.value.solver === "exact" && this.result.value?.options.solver !== "exact";
    if (document !== null && (wanted || asked !== this.asked)) this.solveLive(document);
  }

  /** Runs the solver that was chosen. */
  async solve(): Promise<void> {
    const document = this.wanted ?? this.document.value;
    if (document === null) return;
    this.live.clear();
    const options = optionsOf(this.form.value);
    if (typeof options === "string") return this.refuse(options);
    this.ran.value = options.solver;
    this.begin();
    await this.perform({ document, options, at: "end" });
  }

  /** Ends the solve under way; the best plan found so far is kept. */
  cancel(): void {
    this.client.cancel();
  }

  /** Shows another plan than the result's: `title` says whose. */
  async showPlan(plan: string[], title: string): Promise<void> {
    const trace = await this.replay(plan);
    if (trace === null) return;
    batch(() => {
      this.mode.value = "plan";
      this.chosen.value = title;
      this.hasPlan.value = true;
      this.timeline.pause();
      this.timeline.show(trace, "end");
    });
  }

  /** Shows what was solved again. */
  showResult(): void {
    const trace = this.resultTrace;
    batch(() => {
      this.mode.value = "plan";
      this.chosen.value = null;
      this.timeline.pause();
      if (trace !== null) this.timeline.show(trace, "end");
      this.hasPlan.value = (this.result.value?.outcome.plan ?? null) !== null;
    });
  }

  /** Shows steps that are no solver's, in the mode they belong to. */
  showWalk(mode: Mode, trace: Trace, at: "start" | "end"): void {
    batch(() => {
      this.mode.value = mode;
      this.chosen.value = null;
      this.hasPlan.value = true;
      this.timeline.pause();
      this.timeline.show(trace, at);
    });
  }

  /** The steps of a plan on the open document; null where it has no such steps, and the page says why. */
  async replay(plan: string[]): Promise<Trace | null> {
    const document = this.document.value;
    if (document === null) return null;
    // A solve under way goes on.
    const client = this.status.value === "solving" ? this.aside : this.client;
    const ending = await client.run({ kind: "trace", document: document.text, plan });
    if (ending.kind === "traced") return ending.trace;
    this.failed(ending);
    return null;
  }

  /** The steps of a plan and what can be done after it; a sentence where the plan has no such steps. */
  async walk(plan: string[]): Promise<{ trace: Trace; next: NextAction[] } | string | null> {
    const document = this.document.value;
    if (document === null) return null;
    const ending = await this.client.run({ kind: "walk", document: document.text, plan });
    if (ending.kind === "walked") return ending;
    if (ending.kind === "refused") return ending.message;
    this.failed(ending);
    return null;
  }

  /** Says that something can't be used, and leaves the rest as it is. */
  refuse(message: string): void {
    this.client.drop();
    this.failed({ kind: "refused", message });
  }

  dispose(): void {
    this.timeline.pause();
    this.stopwatch.stop();
    this.live.clear();
    this.client.dispose();
    this.walker.dispose();
    this.guess.dispose();
    this.aside.dispose();
    this.adviser.dispose();
    this.comparison.dispose();
    this.tradeoff.dispose();
    if (this.status.value === "solving") this.status.value = "idle";
  }

  private travel(step: (present: OpenDocument) => OpenDocument | undefined): void {
    const present = this.wanted ?? this.document.value;
    const target = present === null ? undefined : step(present);
    if (target === undefined) return;
    this.before = null;
    this.wanted = target;
    this.solveLive(target);
  }

  private solveLive(document: OpenDocument): void {
    this.timeline.pause();
    const options = exactOptions(this.form.value);
    if (typeof options === "string") {
      this.refuse(options);
      return;
    }
    this.asked = JSON.stringify(options);
    this.begin();
    this.live.ask({ document, options, at: "same" });
  }

  private begin(): void {
    this.timeline.pause();
    this.guess.end();
    if (this.status.value !== "solving") this.stopwatch.start();
    batch(() => {
      this.error.value = null;
      this.status.value = "solving";
    });
  }

  private async perform({ document, options, at }: Job): Promise<void> {
    this.progress.value = null;
    const ending = await this.client.run({ kind: "solve", document: document.text, options }, (update) =>
      this.update(document, update, at),
    );
    if (ending.kind === "refused" && this.refit(document)) return;
    if (ending.kind !== "solved") return this.failed(ending);
    this.stopwatch.stop();
    const { scene, outcome, trace } = ending;
    batch(() => {
      this.take(document, scene);
      this.result.value = { options, outcome };
      if (options.solver === "exact") this.optimum.value = this.result.value;
      this.status.value = this.live.waits ? "solving" : outcome.status;
      this.progress.value = null;
      this.slow.value = false;
      this.mode.value = "plan";
      this.chosen.value = null;
      this.hasPlan.value = outcome.plan !== null;
      this.resultTrace = trace;
      this.timeline.show(trace, at);
    });
  }

  private update(document: OpenDocument, update: Update, at: Job["at"]): void {
    batch(() => {
      if (update.kind === "progress") {
        this.progress.value = update.progress;
        return;
      }
      this.slow.value = true;
      if (this.document.value === document) return;
      this.take(document, update.scene);
      this.result.value = null;
      this.resultTrace = update.start;
      this.mode.value = "plan";
      this.chosen.value = null;
      this.hasPlan.value = false;
      this.timeline.show(update.start, at);
    });
  }

  private take(document: OpenDocument, scene: Scene): void {
    if (this.wanted === document) this.wanted = null;
    if (this.document.value === document) return;
    this.document.value = document;
    this.scene.value = scene;
    this.optimum.value = null;
    this.story.forget();
  }

  /** Bounds that ask for more goals than an edit has left are brought down, and the edit is solved with those. */
  private refit(document: OpenDocument): boolean {
    const scene = this.scene.value;
    if (this.document.value !== document || scene === null) return false;
    const change = fitted(this.form.value, scene);
    if (change === null) return false;
    this.form.value = { ...this.form.value, ...change };
    this.solveLive(document);
    return true;
  }

  private failed(ending: Ending): void {
    // What came after a stale task sets the state itself.
    if (ending.kind !== "refused" && ending.kind !== "lost") return;
    this.stopwatch.stop();
    this.wanted = null;
    const present = this.document.value;
    if (present !== null) this.history.forget(present);
    batch(() => {
      this.progress.value = null;
      this.slow.value = false;
      this.status.value = "error";
      this.error.value =
        ending.kind === "refused"
          ? ending.message
          : `The solver stopped unexpectedly (${ending.message}). Your problem is as it was, and another solver is ready.`;
    });
  }
}
