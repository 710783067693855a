// Time: the steps that can be walked through, and which of them is shown. Everything on the page follows `step`.
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Trace, TraceStep } from "../core.js";

/** Steps a second. */
export const speeds = [0.75, 1.5, 3, 6] as const;
export type Speed = (typeof speeds)[number];

export class Timeline {
  readonly trace = signal<Trace | null>(null);
  readonly step = signal(0);
  readonly playing = signal(false);
  readonly speed = signal<Speed>(1.5);

  readonly lastStep: ReadonlySignal<number> = computed(() => Math.max(0, (this.trace.value?.steps.length ?? 1) - 1));
  readonly shown: ReadonlySignal<TraceStep | null> = computed(() => this.trace.value?.steps[this.step.value] ?? null);

  private timer: ReturnType<typeof setInterval> | undefined;

  /** Shows other steps. Who stood at the end stands at the end again. */
  show(trace: Trace, at: "start" | "end" | "same"): void {
    const last = trace.steps.length - 1;
    const stood = this.step.value;
    const wasAtEnd = this.trace.value === null || stood === this.lastStep.value;
    this.trace.value = trace;
    if (at === "start") this.step.value = 0;
    else this.step.value = at === "end" || wasAtEnd ? last : Math.min(stood, last);
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
    this.tick();
  }

  pause(): void {
    clearInterval(this.timer);
    this.timer = undefined;
    this.playing.value = false;
  }

  setSpeed(speed: Speed): void {
    this.speed.value = speed;
    if (this.playing.value) this.tick();
  }

  private tick(): void {
    clearInterval(this.timer);
    this.timer = setInterval(() => {
      // The steps may have become fewer meanwhile.
      this.step.value = Math.min(this.lastStep.value, this.step.value + 1);
      if (this.step.value >= this.lastStep.value) this.pause();
    }, 1000 / this.speed.value);
  }
}
