// How long something has been at work, for people: it ticks while it runs.
import { signal } from "@preact/signals-core";

const TICK_MS = 200;

export class Stopwatch {
  readonly seconds = signal(0);
  private since = 0;
  private timer: ReturnType<typeof setInterval> | undefined;
  /** The seconds that had passed when it was halted while it ran. */
  private halted: number | null = null;

  start(): void {
    this.stop();
    this.seconds.value = 0;
    this.run(0);
  }

  /** Resolves to the seconds since the start. */
  stop(): number {
    clearInterval(this.timer);
    this.timer = undefined;
    this.halted = null;
    return this.passed();
  }

  /** Stands still until `goOn`, if it runs. */
  halt(): void {
    if (this.timer === undefined) return;
    const passed = this.stop();
    this.halted = passed;
  }

  goOn(): void {
    if (this.halted !== null) this.run(this.halted);
  }

  /** Runs as if it had begun so long ago. */
  private run(seconds: number): void {
    this.halted = null;
    this.since = performance.now() - seconds * 1000;
    this.timer = setInterval(() => {
      this.seconds.value = this.passed();
    }, TICK_MS);
  }

  private passed = (): number => (performance.now() - this.since) / 1000;
}
