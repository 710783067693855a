// What is worked out beside the solver: why there is no plan and what would do, and the best possible where another solver
// was faster.
import { effect, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Advice } from "../core.js";
import { runWithin } from "../worker/patience.js";
import type { Task } from "../worker/protocol.js";
import { TaskRunner } from "../worker/runner.js";
import type { Answer, Result } from "./answer.js";
import { exactOptions, type Form } from "./form.js";
import type { OpenDocument, OpenProblem } from "./open-problem.js";

/** What is found by then is said to be that. */
const PATIENCE_MS = 5000;

interface Stores {
  problem: Pick<OpenProblem, "document">;
  answer: Pick<Answer, "result" | "optimum" | "status">;
  form: ReadonlySignal<Form>;
}

export class Adviser {
  /** What is advised on the result shown, where it has no plan; null while that is not known. */
  readonly advice = signal<Advice | null>(null);
  private readonly runner = new TaskRunner("soon");

  constructor(private readonly stores: Stores) {
    const { problem, answer } = stores;
    effect(() => {
      const document = problem.document.value;
      const result = answer.result.value;
      const settled = !["idle", "solving", "error"].includes(answer.status.value);
      this.runner.drop();
      this.advice.value = null;
      if (document === null || !settled) return;
      if (answer.optimum.value === null) void this.findOptimum(document);
      else if (result?.outcome.status === "infeasible") void this.advise(document, result);
    });
  }

  sleep(): void {
    this.runner.sleep();
  }

  wake(): void {
    this.runner.wake();
  }

  private async findOptimum(document: OpenDocument): Promise<void> {
    const { problem, answer, form } = this.stores;
    const options = exactOptions(form.peek());
    if (typeof options === "string") return;
    const ending = await this.run({ kind: "solve", document: document.text, options });
    if (ending.kind !== "solved" || problem.document.peek() !== document) return;
    answer.optimum.value = { options, outcome: ending.outcome };
  }

  private async advise(document: OpenDocument, result: Result): Promise<void> {
    const ending = await this.run({ kind: "advise", document: document.text, options: result.options });
    if (ending.kind === "advised" && this.stores.answer.result.peek() === result) this.advice.value = ending.advice;
  }

  private run(task: Task) {
    return runWithin(this.runner, task, { milliseconds: PATIENCE_MS });
  }
}
