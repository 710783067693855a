// How long something has been at work, for people: it ticks while it runs.
import { signal } from "@preact/signals-core";

const TICK_MS = 200;

export class Stopwatch {
  readonly seconds = signal(0);
  private since = 0;
  private timer: ReturnType<typeof setInterval> | undefined;

  start(): void {
    this.stop();
    this.since = performance.now();
    this.seconds.value = 0;
    this.timer = setInterval(() => {
      this.seconds.value = this.passed();
    }, TICK_MS);
  }

  /** Resolves to the seconds since the start. */
  stop(): number {
    clearInterval(this.timer);
    this.timer = undefined;
    return this.passed();
  }

  private passed = (): number => (performance.now() - this.since) / 1000;
}
