// Edits come faster than answers: while one is worked on, only the newest of those that follow is kept. One that takes
// long is given up for it.

/** An answer that is nearly there is better than starting anew with every move of the pointer. */
const PATIENCE_MS = 120;

export class Coalesce<T> {
  private busySince: number | null = null;
  private waiting: { job: T } | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private run = 0;

  /** `work` is called for one job at a time; a later call makes the one before it stale. */
  constructor(private readonly work: (job: T) => Promise<unknown>) {}

  /** Whether a newer job than the one that is worked on is there. */
  get waits(): boolean {
    return this.waiting !== null;
  }

  ask(job: T): void {
    this.waiting = { job };
    if (this.busySince === null) {
      void this.next();
      return;
    }
    clearTimeout(this.timer);
    const left = PATIENCE_MS - (performance.now() - this.busySince);
    this.timer = setTimeout(() => void this.next(), Math.max(0, left));
  }

  /** Nothing that waits is worked on any more. */
  clear(): void {
    this.waiting = null;
    clearTimeout(this.timer);
  }

  private async next(): Promise<void> {
    clearTimeout(this.timer);
    const waiting = this.waiting;
    if (waiting === null) return;
    this.waiting = null;
    this.busySince = performance.now();
    this.run += 1;
    const run = this.run;
    await this.work(waiting.job);
    // One that was given up ends late; the one that took its place is at work.
    if (run !== this.run) return;
    this.busySince = null;
    if (this.waiting !== null) await this.next();
  }
}
