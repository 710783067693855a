// Pictures of what the boards show, drawn by the core.
import type { PictureOptions } from "../core.js";
import { TaskRunner } from "../worker/runner.js";
import type { Boards } from "./boards.js";
import { lost } from "./lost.js";
import type { OpenProblem } from "./open-problem.js";
import type { Timeline } from "./timeline.js";

/** Why an observer's board is not drawn. */
const VEILED =
  "The question of this problem hides what observers believe until it is answered: the agent’s board alone (actor) can be drawn.";

interface Stores {
  problem: Pick<OpenProblem, "veiled">;
  boards: Pick<Boards, "document" | "mode">;
  timeline: Pick<Timeline, "trace" | "step">;
}

export class Pictures {
  private readonly runner = new TaskRunner("now");
  /** One picture after the other: a newer task of the runner would end the older one. */
  private queue: Promise<unknown> = Promise.resolve();
  private waiting = 0;
  private asleep = false;

  constructor(private readonly stores: Stores) {}

  /** The step shown as SVG, unless the options name another, or all. Rejects with a sentence where there is no picture. */
  draw(options: PictureOptions): Promise<string> {
    // What is shown now, and not what is shown when the turn comes.
    const { boards, timeline } = this.stores;
    const document = boards.document.value;
    const steps = timeline.trace.value?.steps ?? [];
    const plan = steps.flatMap(({ action }) => (action === null ? [] : [action]));
    const wanted = { step: timeline.step.value, ...options };
    const veiled = this.stores.problem.veiled.value && options.board !== "actor";
    const guessing = boards.mode.value === "guess";
    this.waiting += 1;
    const drawn = this.queue.then(() => {
      if (guessing) throw new Error("There is no picture while a goal is being guessed: it would tell which.");
      if (veiled) throw new Error(VEILED);
      if (document === null || steps.length === 0) throw new Error("There is nothing to draw.");
      return this.ask(document, plan, wanted);
    });
    this.queue = drawn.then(
      () => this.ended(),
      () => this.ended(),
    );
    return drawn;
  }

  /** A picture takes little time, and is drawn out of the page as well; then the worker is given back. */
  sleep(): void {
    this.asleep = true;
    if (this.waiting === 0) this.runner.dispose();
  }

  wake(): void {
    this.asleep = false;
  }

  private ended(): void {
    this.waiting -= 1;
    if (this.asleep && this.waiting === 0) this.runner.dispose();
  }

  private async ask(document: string, plan: string[], options: PictureOptions): Promise<string> {
    const ending = await this.runner.run({ kind: "picture", document, plan, options });
    if (ending.kind === "drawn") return ending.svg;
    if (ending.kind === "refused") throw new Error(ending.message);
    throw new Error(ending.kind === "lost" ? lost(ending) : "The picture was given up.");
  }
}
