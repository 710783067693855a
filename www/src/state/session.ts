// What is open, what the solver makes of it, and which steps are shown.
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { NextAction, Progress, Scene, SolveOptions, Trace } from "../core.js";
import { type Ending, SolverClient } from "../worker/client.js";
import type { Update } from "../worker/protocol.js";
import { Coalesce } from "./coalesce.js";
import { emptyForm, exactOptions, type Form, optionsOf } from "./form.js";
import { GoalStory } from "./goal-story.js";
import { fitted } from "./numbers.js";
import type { Mode, OpenDocument, Result, Status } from "./result.js";
import { Stopwatch } from "./stopwatch.js";
import { Timeline } from "./timeline.js";

/** What takes longer is seen to take long, and can be cancelled. */
const SLOW_MS = 300;

interface Job {
  document: OpenDocument;
  options: SolveOptions;
  /** Which step to show then. */
  at: "start" | "end" | "same";
}

export abstract class Session {
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
  /** The solver that was run by hand last, on this problem or on what it was edited from. */
  readonly ran = signal<Form["solver"] | null>(null);
  readonly story = new GoalStory(this.timeline);
  /** How long the solver has been at work. */
  readonly stopwatch = new Stopwatch();

  /** The goal difference at the end of the plan shown; null while there is none. */
  readonly difference: ReadonlySignal<number | null> = computed(() => {
    if (this.mode.value === "guess") return null;
    const trace = this.timeline.trace.value;
    return trace?.valid && this.hasPlan.value ? trace.goal_difference : null;
  });
  protected readonly hasPlan = signal(false);
  /** The steps of the result, to come back to. */
  protected resultTrace: Trace | null = null;
  /** The newest document that was asked for, while the core has not said whether it is right. */
  protected wanted: OpenDocument | null = null;
  /** What the best possible was asked for last. */
  protected asked = "";
  protected readonly live = new Coalesce<Job>((job) => this.perform(job));

  /** For short questions while the other solves. */
  protected readonly aside = new SolverClient();

  constructor(protected readonly client: SolverClient) {}

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

  /** Shows another plan than the result's: `title` says whose; `wanted`, whether it is still, once its steps are there. */
  async showPlan(plan: string[], title: string, wanted = () => true): Promise<void> {
    const trace = await this.replay(plan);
    if (trace === null || !wanted()) return;
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

  /** The person has read what went wrong: what is shown is the last answer again. */
  dismiss(): void {
    if (this.status.value !== "error") return;
    this.error.value = null;
    this.status.value = this.result.value?.outcome.status ?? "idle";
  }

  /** The core did not take the edit asked for. */
  protected abstract editRefused(): void;

  /** Work is begun that takes the place of whatever is shown. */
  protected abstract leaveGames(): void;

  dispose(): void {
    this.timeline.pause();
    this.stopwatch.stop();
    this.live.clear();
    this.client.dispose();
    this.aside.dispose();
    if (this.status.value === "solving") this.status.value = "idle";
  }

  protected solveLive(document: OpenDocument): void {
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

  protected begin(): void {
    this.timeline.pause();
    if (this.status.value !== "solving") this.stopwatch.start();
    batch(() => {
      this.error.value = null;
      this.status.value = "solving";
    });
  }

  protected async perform({ document, options, at }: Job): Promise<void> {
    this.progress.value = null;
    // The worker itself can say nothing in the middle of a long piece of work.
    const waiting = setTimeout(() => {
      this.slow.value = true;
    }, SLOW_MS);
    const ending = await this.client.run({ kind: "solve", document: document.text, options }, (update) =>
      this.update(document, update, at),
    );
    clearTimeout(waiting);
    if (ending.kind === "refused" && this.refit(document)) return;
    if (ending.kind !== "solved") return this.failed(ending);
    this.stopwatch.stop();
    const { scene, outcome, trace } = ending;
    batch(() => {
      this.leaveGames();
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
    if (update.kind === "started" || update.kind === "fetching") return;
    batch(() => {
      if (update.kind === "progress") {
        this.progress.value = update.progress;
        return;
      }
      this.slow.value = true;
      if (this.document.value === document) return;
      this.leaveGames();
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

  protected failed(ending: Ending): void {
    // What came after a stale task sets the state itself.
    if (ending.kind !== "refused" && ending.kind !== "lost") return;
    this.stopwatch.stop();
    this.wanted = null;
    this.editRefused();
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
