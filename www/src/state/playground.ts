// The playground's state, all in one place, and what can be done to it. Views read the signals and call the actions.
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Outcome, Progress, Scene, SolveOptions, Trace, TraceStep } from "../core.js";
import type { Ending, SolverClient } from "../worker/client.js";
import type { Answered } from "../worker/protocol.js";
import { emptyForm, type Form, optionsOf } from "./form.js";
import { Player } from "./player.js";

export type Status = "idle" | "solving" | "error" | Outcome["status"];

/** What the last solve was asked and answered. */
export interface Result {
  options: SolveOptions;
  outcome: Answered;
}

export class Playground {
  /** The document that is open; what is drawn comes from it. */
  readonly document = signal("");
  /** What stands in the text field, not opened yet. */
  readonly draft = signal("");
  readonly scene = signal<Scene | null>(null);
  /** The steps that can be walked through: those of the plan, or the start alone. */
  readonly trace = signal<Trace | null>(null);
  readonly result = signal<Result | null>(null);
  readonly status = signal<Status>("idle");
  readonly error = signal<string | null>(null);
  readonly progress = signal<Progress | null>(null);
  readonly form = signal<Form>(emptyForm);
  readonly step = signal(0);
  readonly playing = signal(false);

  readonly lastStep: ReadonlySignal<number> = computed(() => Math.max(0, (this.trace.value?.steps.length ?? 1) - 1));
  readonly shown: ReadonlySignal<TraceStep | null> = computed(() => this.trace.value?.steps[this.step.value] ?? null);

  private readonly player = new Player();

  constructor(private readonly client: SolverClient) {}

  /** Opens a document and solves it. One that can't be read leaves everything as it was. */
  async open(document: string): Promise<void> {
    this.pause();
    batch(() => {
      this.draft.value = document;
      this.error.value = null;
      this.progress.value = null;
      this.status.value = "solving";
    });
    const ending = await this.client.run({ kind: "open", document });
    if (ending.kind !== "opened") return this.failed(ending);
    batch(() => {
      this.document.value = document;
      this.scene.value = ending.scene;
      this.show(ending.start, 0);
      this.result.value = null;
    });
    await this.solve();
  }

  async solve(): Promise<void> {
    if (this.scene.value === null) return;
    this.pause();
    const options = optionsOf(this.form.value);
    if (typeof options === "string") return this.refuse(options);
    batch(() => {
      this.error.value = null;
      this.progress.value = null;
      this.status.value = "solving";
    });
    const document = this.document.value;
    const ending = await this.client.run({ kind: "solve", document, options }, (progress) => {
      this.progress.value = progress;
    });
    if (ending.kind !== "solved") return this.failed(ending);
    batch(() => {
      this.result.value = { options, outcome: ending.outcome };
      this.status.value = ending.outcome.status;
      this.progress.value = null;
      if (ending.trace !== null) this.show(ending.trace, ending.trace.steps.length - 1);
      else this.showStart();
    });
  }

  /** Ends the solve under way; the best plan found so far is kept. */
  cancel(): void {
    this.client.cancel();
  }

  edit(change: Partial<Form>): void {
    this.form.value = { ...this.form.value, ...change };
  }

  goTo(step: number): void {
    this.pause();
    this.step.value = Math.min(this.lastStep.value, Math.max(0, step));
  }

  /** Plays from the step shown, or from the start when the last is shown. */
  play(): void {
    if (this.lastStep.value === 0) return;
    if (this.step.value === this.lastStep.value) this.step.value = 0;
    this.playing.value = true;
    this.player.start(() => {
      this.step.value += 1;
      if (this.step.value < this.lastStep.value) return true;
      this.playing.value = false;
      return false;
    });
  }

  pause(): void {
    this.player.stop();
    this.playing.value = false;
  }

  /** Says that something can't be used, and leaves the rest as it is. */
  refuse(message: string): void {
    this.client.drop();
    this.failed({ kind: "refused", message });
  }

  dispose(): void {
    this.pause();
    this.client.dispose();
    if (this.status.value === "solving") this.status.value = "idle";
  }

  private show(trace: Trace, step: number): void {
    this.trace.value = trace;
    this.step.value = step;
  }

  /** Without a plan there is the start alone to see. */
  private showStart(): void {
    const start = this.trace.value?.steps[0];
    if (start !== undefined) {
      this.show({ valid: true, steps: [start], goal_difference: start.goal_difference }, 0);
    }
  }

  private failed(ending: Ending): void {
    // What came after a stale task sets the state itself.
    if (ending.kind !== "refused" && ending.kind !== "lost") return;
    batch(() => {
      this.progress.value = null;
      this.status.value = "error";
      this.error.value =
        ending.kind === "refused"
          ? ending.message
          : `The solver stopped unexpectedly (${ending.message}). Your problem is as it was, and another solver is ready.`;
    });
  }
}
