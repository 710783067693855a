// What is worked out beside the solver, in a worker of its own: why there is no plan and what would do, and the best
// possible where another solver was faster.
import { effect, signal } from "@preact/signals-core";
import type { Advice } from "../core.js";
import { SolverClient } from "../worker/client.js";
import type { Task } from "../worker/protocol.js";
import { exactOptions } from "./form.js";
import type { OpenDocument, Playground, Result } from "./playground.js";

/** Nobody waits for it: what is found by then is said to be that. */
const PATIENCE_MS = 5000;

export class Adviser {
  /** What is advised on the result shown, where it has no plan; null while that is not known. */
  readonly advice = signal<Advice | null>(null);
  private readonly client = new SolverClient();

  constructor(private readonly playground: Playground) {
    effect(() => {
      const document = playground.document.value;
      const result = playground.result.value;
      const settled = !["idle", "solving", "error"].includes(playground.status.value);
      this.client.drop();
      this.advice.value = null;
      if (document === null || !settled) return;
      if (playground.optimum.value === null) void this.findOptimum(document);
      else if (result?.outcome.status === "infeasible") void this.advise(document, result);
    });
  }

  dispose(): void {
    this.client.dispose();
  }

  private async findOptimum(document: OpenDocument): Promise<void> {
    const options = exactOptions(this.playground.form.peek());
    if (typeof options === "string") return;
    const ending = await this.run({ kind: "solve", document: document.text, options });
    if (ending.kind !== "solved" || this.playground.document.peek() !== document) return;
    this.playground.optimum.value = { options, outcome: ending.outcome };
  }

  private async advise(document: OpenDocument, result: Result): Promise<void> {
    const ending = await this.run({ kind: "advise", document: document.text, options: result.options });
    if (ending.kind === "advised" && this.playground.result.peek() === result) this.advice.value = ending.advice;
  }

  private run(task: Task) {
    const patience = { milliseconds: PATIENCE_MS, expired: () => this.client.cancel() };
    return this.client.run(task, undefined, patience);
  }
}
