// A worker whose script the browser may refuse although it is there, as where the page has an embedder policy
// (`Cross-Origin-Embedder-Policy: require-corp`) and the answer with the script has none: a copy then takes its place,
// which has the policy of the page.

import type { SolverWorker } from "./later.js";
import { NotLoaded } from "./not-loaded.js";
import { chosenPlaces } from "./places.js";
import { whyForbidden } from "./policy.js";

export class Refusable implements SolverWorker {
  onmessage: Worker["onmessage"] = null;
  onmessageerror: Worker["onmessageerror"] = null;
  onerror: Worker["onerror"] = null;
  /** What was said before the worker's first word, which a copy is to hear as well. */
  private unheard: unknown[] | null = [];
  private ended = false;

  constructor(
    private worker: SolverWorker,
    private readonly copy: () => Promise<SolverWorker>,
  ) {
    this.listen(worker);
    worker.onerror = (event) => {
      // A script that was refused has no message.
      if (this.unheard === null || event.message || whyForbidden() !== null)
        this.onerror?.call(worker as Worker, event);
      else void this.replace(event);
    };
  }

  postMessage(message: unknown): void {
    this.unheard?.push(message);
    this.worker.postMessage(message);
  }

  terminate(): void {
    this.ended = true;
    this.worker.terminate();
  }

  private listen(worker: SolverWorker): void {
    worker.onmessage = (event) => {
      this.unheard = null;
      this.onmessage?.call(worker as Worker, event);
    };
    worker.onmessageerror = (event) => this.onmessageerror?.call(worker as Worker, event);
  }

  private async replace(refused: ErrorEvent): Promise<void> {
    refused.preventDefault();
    const before = this.worker as Worker;
    let copy: SolverWorker;
    try {
      copy = await this.copy();
    } catch (error) {
      // The script is not to be had at all.
      if (!this.ended) this.onerror?.call(before, this.says(error) ?? refused);
      return;
    }
    before.terminate();
    if (this.ended) {
      copy.terminate();
      return;
    }
    this.worker = copy;
    this.listen(copy);
    copy.onerror = (event) => this.onerror?.call(copy as Worker, event);
    for (const message of this.unheard ?? []) copy.postMessage(message);
    this.unheard = null;
  }

  /** Which address did not come; one that the page itself places is said with its attribute (client.ts). */
  private says(error: unknown): ErrorEvent | null {
    if (!(error instanceof NotLoaded) || chosenPlaces().worker !== null) return null;
    return new ErrorEvent("error", { message: error.message, error, cancelable: true });
  }
}
