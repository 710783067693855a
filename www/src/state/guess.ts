// You are the enemy: a plan for a goal that you do not know, seen through the enemy's symbols alone, and a guess.
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { BeliefSummary, Scene, Trace, TraceStep } from "../core.js";
import { written } from "../problem/text.js";
import type { Ending } from "../worker/client.js";
import { runWithin } from "../worker/patience.js";
import { TaskRunner } from "../worker/runner.js";
import type { Boards } from "./boards.js";
import type { Solver } from "./form.js";
import type { OpenProblem } from "./open-problem.js";
import type { Plans } from "./plans.js";
import type { Timeline } from "./timeline.js";

/** The other player must be ready by then. */
const PATIENCE_MS = 5000;

export type Round =
  | { kind: "none" }
  | { kind: "hiding" }
  | { kind: "guessing" }
  /** `possible`: how many goals the enemy could not tell apart where the guess was made. */
  | { kind: "over"; guess: string; goal: string; step: number; possible: number }
  | { kind: "impossible" };

interface Stores {
  problem: Pick<OpenProblem, "document" | "scene">;
  boards: Boards;
  timeline: Pick<Timeline, "step">;
  plans: Pick<Plans, "showAnswer">;
}

export class Guess {
  readonly round = signal<Round>({ kind: "none" });
  readonly played = signal(0);
  readonly right = signal(0);
  readonly under: ReadonlySignal<boolean> = computed(() => this.round.value.kind === "guessing");

  private readonly hider = new TaskRunner("now");
  /** The document that was open when the round began. */
  private begun: OpenProblem["document"]["value"] = null;
  private hidden: { goal: string; document: string; scene: Scene; trace: Trace } | null = null;

  constructor(private readonly stores: Stores) {
    // What the boards show by then is another plan's. While the other player hides, an answer for the same problem is
    // nothing that a game shows.
    stores.boards.replaced.add(() => {
      if (this.round.value.kind !== "hiding" || this.stores.problem.document.value !== this.begun) this.end();
    });
  }

  /** Draws a goal and has a best plan for it walked in secret. */
  async start(): Promise<void> {
    const { document, scene } = this.stores.problem;
    const open = document.value;
    if (open === null || scene.value === null) return;
    this.begun = open;
    this.round.value = { kind: "hiding" };
    const goals = scene.value.goals.map(({ name }) => name);
    while (goals.length > 0) {
      const [goal = ""] = goals.splice(drawn(goals.length), 1);
      const secret = written({ ...open.value, true_goal: goal } as typeof open.value);
      const ending = await this.way(secret);
      if (ending.kind === "stale" || this.round.value.kind !== "hiding") return;
      // A goal that can't be reached is not worth a guess.
      if (ending.kind !== "solved" || ending.outcome.plan === null) continue;
      this.hide(goal, secret, ending.scene, ending.trace);
      return;
    }
    this.round.value = { kind: "impossible" };
  }

  /** The best way, or a good one where the best takes too long to wait for. */
  private async way(document: string): Promise<Ending> {
    const best = await this.patiently(document, "exact");
    if (best.kind !== "solved" || best.outcome.plan !== null || best.outcome.status !== "limit") return best;
    return this.patiently(document, "satisficing");
  }

  private patiently(document: string, solver: Solver): Promise<Ending> {
    return runWithin(this.hider, { kind: "solve", document, options: { solver } }, { milliseconds: PATIENCE_MS });
  }

  /** Says which goal the agent is after. */
  guess(guess: string): void {
    const { timeline, boards } = this.stores;
    if (this.hidden === null || this.round.value.kind !== "guessing") return;
    const { goal, document, scene, trace } = this.hidden;
    const step = timeline.step.value;
    batch(() => {
      this.played.value += 1;
      if (guess === goal) this.right.value += 1;
      const possible = trace.steps[step]?.goals.adversarial.length ?? 0;
      this.round.value = { kind: "over", guess, goal, step, possible };
      boards.disguise.value = { scene, document };
      boards.showSteps("plan", trace, "end");
    });
  }

  /** Puts everything back as it was before the game. */
  leave(): void {
    this.end();
    this.stores.plans.showAnswer();
  }

  /** The document has changed: the game is over, and what is shown is somebody else's. */
  end(): void {
    if (this.round.value.kind === "none") return;
    this.hider.drop();
    batch(() => {
      this.round.value = { kind: "none" };
      this.stores.boards.disguise.value = null;
    });
    this.hidden = null;
  }

  sleep(): void {
    this.hider.sleep();
  }

  wake(): void {
    this.hider.wake();
  }

  private hide(goal: string, document: string, scene: Scene, trace: Trace): void {
    const { boards } = this.stores;
    this.hidden = { goal, document, scene, trace };
    batch(() => {
      this.round.value = { kind: "guessing" };
      // No view can tell which goal is the true one.
      boards.disguise.value = { scene: { ...scene, true_goal: "" }, document: null };
      boards.showSteps("guess", { ...trace, goal_difference: 0, steps: trace.steps.map(enemysView) }, "start");
    });
  }
}

/** A belief that is kept from the player. */
const nothing: BeliefSummary = { states: 0, shares: [], left_out: 0, goals: [] };

/** A whole number below `count`. */
function drawn(count: number): number {
  const [value = 0] = crypto.getRandomValues(new Uint32Array(1));
  return value % count;
}

/** A step with nothing in it that the enemy is not told. (The state stays for the drawing, which hides it.) */
function enemysView(step: TraceStep): TraceStep {
  return {
    ...step,
    action: null,
    symbols: { ...step.symbols, cooperative: null },
    beliefs: { ...step.beliefs, cooperative: [] },
    ...(step.summaries === undefined ? {} : { summaries: { ...step.summaries, cooperative: nothing } }),
    goals: { ...step.goals, cooperative: [] },
    goal_difference: 0,
  };
}
