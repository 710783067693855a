// You are the agent: a walk made by hand, step by step, and how good it is.
import { batch, signal } from "@preact/signals-core";
import type { NextAction, Trace } from "../core.js";
import type { Answered } from "../worker/protocol.js";
import { TaskRunner } from "../worker/runner.js";
import type { Boards } from "./boards.js";
import type { OpenProblem } from "./open-problem.js";
import type { Plans } from "./plans.js";
import type { Timeline } from "./timeline.js";

export type Verdict =
  | { kind: "walking" }
  | { kind: "comparing"; difference: number; moves: number }
  | { kind: "compared"; difference: number; moves: number; best: Answered };

interface Stores {
  problem: Pick<OpenProblem, "document">;
  boards: Boards;
  timeline: Pick<Timeline, "step">;
  plans: Plans;
}

export class Walk {
  /** What can be done after the step shown. */
  readonly next = signal<readonly NextAction[]>([]);
  readonly message = signal("");
  /** Words of the action that is looked for. */
  readonly wanted = signal("");
  readonly verdict = signal<Verdict>({ kind: "walking" });

  private plan: readonly string[] = [];
  /** The step that `next` belongs to. */
  private asked = -1;
  private readonly judge = new TaskRunner("soon");
  /** One step after the other, however fast the keys come. */
  private queue: Promise<void> = Promise.resolve();

  constructor(private readonly stores: Stores) {}

  start(): Promise<void> {
    this.message.value = "";
    return this.enqueue(() => this.show([]));
  }

  /** Goes on with a walk that was made elsewhere. */
  resume(plan: readonly string[]): Promise<void> {
    this.message.value = "";
    return this.enqueue(() => this.show(plan));
  }

  /** Takes an action from the step shown; what was walked beyond it is left. */
  take(action: string): Promise<void> {
    return this.enqueue(async () => {
      if (this.stores.boards.mode.value !== "walk") return;
      await this.show([...this.plan.slice(0, this.stores.timeline.step.value), action], action);
    });
  }

  /** Takes the last action back. */
  back(): Promise<void> {
    return this.enqueue(() => this.show(this.plan.slice(0, -1)));
  }

  /** Another step may be shown: then something else can be done. */
  async follow(): Promise<void> {
    const { boards, timeline, plans } = this.stores;
    const step = timeline.step.value;
    if (boards.mode.value !== "walk" || step === this.asked) return;
    this.asked = step;
    await this.enqueue(async () => {
      const walked = await plans.walk(this.plan.slice(0, step));
      if (walked !== null && typeof walked !== "string" && this.asked === step) this.next.value = walked.next;
    });
  }

  async showBest(): Promise<void> {
    const verdict = this.verdict.value;
    if (verdict.kind !== "compared" || verdict.best.plan === null) return;
    await this.stores.plans.show(verdict.best.plan, `The best plan with ${verdict.moves} actions`);
  }

  leave(): void {
    this.judge.drop();
    this.stores.plans.showAnswer();
  }

  sleep(): void {
    this.judge.sleep();
  }

  wake(): void {
    this.judge.wake();
  }

  private enqueue(work: () => Promise<void>): Promise<void> {
    this.queue = this.queue.then(work);
    return this.queue;
  }

  private async show(plan: readonly string[], action?: string): Promise<void> {
    const walked = await this.stores.plans.walk([...plan]);
    if (walked === null) return;
    if (typeof walked === "string") {
      this.message.value = action === undefined ? walked : `You can't do “${action}” here.`;
      return;
    }
    const { trace, next } = walked;
    batch(() => {
      this.plan = plan;
      this.asked = plan.length;
      this.next.value = next;
      this.message.value = "";
      this.wanted.value = "";
      this.stores.boards.showSteps("walk", trace, "end");
    });
    await this.compare(plan, trace);
  }

  private async compare(plan: readonly string[], trace: Trace): Promise<void> {
    const document = this.stores.problem.document.value;
    // Where solvers are closed, nothing is told of the best.
    if (!trace.valid || document === null || document.closed) {
      this.judge.drop();
      this.verdict.value = { kind: "walking" };
      return;
    }
    const own = { difference: trace.goal_difference, moves: plan.length };
    this.verdict.value = { kind: "comparing", ...own };
    const options = { solver: "exact", horizon: plan.length } as const;
    // The next step does not wait for it.
    void this.judge.run({ kind: "solve", document: document.text, options }).then((ending) => {
      if (ending.kind === "solved" && this.plan === plan) {
        this.verdict.value = { kind: "compared", ...own, best: ending.outcome };
      }
    });
  }
}
