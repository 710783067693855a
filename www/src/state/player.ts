// Playing the steps: one after another, until the last.
const STEP_MS = 650;

export class Player {
  private timer: ReturnType<typeof setInterval> | undefined;

  /** Calls `next` at every step's time, until it returns false or `stop` is called. */
  start(next: () => boolean): void {
    this.stop();
    this.timer = setInterval(() => {
      if (!next()) this.stop();
    }, STEP_MS);
  }

  stop(): void {
    clearInterval(this.timer);
    this.timer = undefined;
  }
}
