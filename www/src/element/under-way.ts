// The work that a page asked a playground for last, and those who wait for its end. Newer work stands for all before it.

export class UnderWay {
  private newest: Promise<unknown> | null = null;
  private waiting: (() => void)[] = [];

  /** Takes the place of the work that was under way, which may never end. */
  begin<T>(work: Promise<T>): Promise<T> {
    this.newest = work;
    void work.finally(() => {
      if (this.newest !== work) return;
      this.newest = null;
      this.release();
    });
    return work;
  }

  /** Settles once nothing is under way, or what is there may be used. */
  ended(): Promise<void> {
    return this.newest === null ? Promise.resolve() : new Promise((resolve) => this.waiting.push(resolve));
  }

  /** What is there may be used, although the work goes on. */
  release(): void {
    for (const go of this.waiting.splice(0)) go();
  }
}
