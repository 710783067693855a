// Time: the steps that can be walked through, and which of them is shown. Everything on the page follows `step`.
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Trace, TraceStep } from "../core.js";

/** Which step is shown of new steps. `first`: the first, and the end of what an edit makes of them. */
export type At = "first" | "start" | "end" | "same";

/** Steps a second. */
export const speeds = [0.75, 1.5, 3, 6] as const;
export type Speed = (typeof speeds)[number];

export class Timeline {
  readonly trace = signal<Trace | null>(null);
  readonly step = signal(0);
  readonly playing = signal(false);
  readonly speed = signal<Speed>(1.5);

  /** The furthest step that was shown of these steps. */
  readonly seen = signal(0);
  readonly lastStep: ReadonlySignal<number> = computed(() => Math.max(0, (this.trace.value?.steps.length ?? 1) - 1));
  readonly shown: ReadonlySignal<TraceStep | null> = computed(() => this.trace.value?.steps[this.step.value] ?? null);

  private timer: ReturnType<typeof setInterval> | undefined;
  /** Where the person went last: steps that are shown in the meantime may be too few for it. */
  private wanted: number | "end" = "end";

  /** Shows other steps. Who stood at the end stands at the end again. */
  show(trace: Trace, at: At): void {
    const last = trace.steps.length - 1;
    if (at !== "same") this.wanted = at === "start" ? 0 : "end";
    const wanted = at === "first" ? 0 : this.wanted;
    this.trace.value = trace;
    this.step.value = wanted === "end" ? last : Math.min(wanted, last);
    this.seen.value = this.step.value;
  }

  goTo(step: number): void {
    this.pause();
    this.stand(Math.max(0, step));
  }

  /** Plays from the step shown, or from the start when the last is shown. */
  play(): void {
    if (this.lastStep.value === 0) return;
    if (this.step.value === this.lastStep.value) this.stand(0);
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
      this.stand(this.step.value + 1);
      if (this.step.value >= this.lastStep.value) this.pause();
    }, 1000 / this.speed.value);
  }

  private stand(step: number): void {
    const last = this.lastStep.value;
    this.step.value = Math.min(last, step);
    this.seen.value = Math.max(this.seen.value, this.step.value);
    this.wanted = last > 0 && step >= last ? "end" : this.step.value;
  }
}
