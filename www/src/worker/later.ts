// A worker that is still on its way.

/** What a client needs of a worker; it may still be on its way. */
export type SolverWorker = Pick<Worker, "postMessage" | "terminate" | "onmessage" | "onmessageerror" | "onerror">;

/** A worker that is not there yet: what is said to it waits. */
export class Later implements SolverWorker {
  onmessage: Worker["onmessage"] = null;
  onmessageerror: Worker["onmessageerror"] = null;
  onerror: Worker["onerror"] = null;
  private worker: SolverWorker | null = null;
  private readonly waiting: unknown[] = [];
  private ended = false;

  constructor(coming: Promise<SolverWorker>) {
    coming.then(
      (worker) => this.take(worker),
      (error: unknown) => this.fail(error),
    );
  }

  postMessage(message: unknown): void {
    if (this.worker === null) this.waiting.push(message);
    else this.worker.postMessage(message);
  }

  terminate(): void {
    this.ended = true;
    this.worker?.terminate();
  }

  private take(worker: SolverWorker): void {
    if (this.ended) {
      worker.terminate();
      return;
    }
    this.worker = worker;
    worker.onmessage = (event) => this.onmessage?.call(worker as Worker, event);
    worker.onmessageerror = (event) => this.onmessageerror?.call(worker as Worker, event);
    worker.onerror = (event) => this.onerror?.call(worker as Worker, event);
    for (const message of this.waiting.splice(0)) worker.postMessage(message);
  }

  private fail(error: unknown): void {
    if (this.ended) return;
    const message = error instanceof Error ? error.message : String(error);
    this.onerror?.call(null as unknown as Worker, new ErrorEvent("error", { message, error, cancelable: true }));
  }
}
