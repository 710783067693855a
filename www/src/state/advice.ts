// What is worked out beside the solver, in a worker of its own: the best possible where another solver was faster.
import { effect } from "@preact/signals-core";
import { SolverClient } from "../worker/client.js";
import { exactOptions } from "./form.js";
import type { OpenDocument, Playground } from "./playground.js";

/** Nobody waits for it: what is found by then is said to be that. */
const PATIENCE_MS = 5000;

export class Advice {
  private readonly client = new SolverClient();

  constructor(private readonly playground: Playground) {
    effect(() => {
      const document = playground.document.value;
      const settled = !["idle", "solving", "error"].includes(playground.status.value);
      if (document === null || !settled) this.client.drop();
      else if (playground.optimum.value === null) void this.findOptimum(document);
    });
  }

  dispose(): void {
    this.client.dispose();
  }

  private async findOptimum(document: OpenDocument): Promise<void> {
    const options = exactOptions(this.playground.form.peek());
    if (typeof options === "string") return;
    const timer = setTimeout(() => this.client.cancel(), PATIENCE_MS);
    const ending = await this.client.run({ kind: "solve", document: document.text, options });
    clearTimeout(timer);
    if (ending.kind !== "solved" || this.playground.document.peek() !== document) return;
    this.playground.optimum.value = { options, outcome: ending.outcome };
  }
}
