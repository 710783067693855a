// Why the goal that was chosen is not possible for an observer at the step shown: the last states that would have led to
// it, and the symbol that ended them.
import { effect, signal } from "@preact/signals-core";
import type { Eliminations, Trace } from "../core.js";
import type { Role } from "../view/observers.js";
import { TaskRunner } from "../worker/runner.js";
import type { Boards } from "./boards.js";
import type { OpenProblem } from "./open-problem.js";
import type { Timeline } from "./timeline.js";

interface Stores {
  problem: Pick<OpenProblem, "document">;
  boards: Pick<Boards, "story" | "mode">;
  timeline: Timeline;
}

/** What was asked: a goal at a step of these steps. */
interface Question {
  trace: Trace;
  goal: string;
  step: number;
}

export class Why {
  private readonly found = signal<(Question & { eliminations: Eliminations }) | null>(null);
  private readonly runner = new TaskRunner("soon");

  constructor(private readonly stores: Stores) {
    effect(() => {
      const question = this.question();
      const document = stores.problem.document.value;
      if (question !== null && document !== null) void this.ask(document.text, question);
    });
  }

  /** Nothing while it is not known. */
  of(role: Role): { goal: string; cause: Eliminations[Role] } | undefined {
    const [asked, found] = [this.question(), this.found.value];
    if (asked === null || found === null) return undefined;
    const same = found.trace === asked.trace && found.goal === asked.goal && found.step === asked.step;
    return same ? { goal: found.goal, cause: found.eliminations[role] } : undefined;
  }

  sleep(): void {
    this.runner.sleep();
  }

  wake(): void {
    this.runner.wake();
  }

  private question(): Question | null {
    const { boards, timeline } = this.stores;
    const [goal, trace] = [boards.story.goal.value, timeline.trace.value];
    // The enemy's player must not know what the friend was told.
    if (goal === null || trace === null || boards.mode.value === "guess" || timeline.playing.value) return null;
    return { trace, goal, step: timeline.step.value };
  }

  private async ask(document: string, question: Question): Promise<void> {
    const { trace, goal, step } = question;
    const plan = trace.steps.flatMap(({ action }) => (action === null ? [] : [action]));
    const ending = await this.runner.run({ kind: "explain", document, plan, goal, step });
    if (ending.kind === "explained") this.found.value = { ...question, eliminations: ending.eliminations };
  }
}
