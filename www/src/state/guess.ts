// You are the enemy: a plan for a goal that you do not know, seen through the enemy's symbols alone, and a guess.
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { BeliefSummary, Scene, Trace, TraceStep } from "../core.js";
import { written } from "../problem/text.js";
import { type Ending, SolverClient } from "../worker/client.js";
import type { Playground } from "./playground.js";

/** Nobody waits longer for the other player. */
const PATIENCE_MS = 5000;

export type Round =
  | { kind: "none" }
  | { kind: "hiding" }
  | { kind: "guessing" }
  /** `possible`: how many goals the enemy could not tell apart where the guess was made. */
  | { kind: "over"; guess: string; goal: string; step: number; possible: number }
  | { kind: "impossible" };

export class Guess {
  readonly round = signal<Round>({ kind: "none" });
  readonly played = signal(0);
  readonly right = signal(0);
  readonly under: ReadonlySignal<boolean> = computed(() => this.round.value.kind === "guessing");

  private readonly hider = new SolverClient();
  private hidden: { goal: string; scene: Scene; trace: Trace } | null = null;
  /** The scene to come back to. */
  private own: Scene | null = null;

  constructor(private readonly playground: Playground) {}

  /** Draws a goal and has a best plan for it walked in secret. */
  async start(): Promise<void> {
    const { document, scene } = this.playground;
    this.own ??= scene.value;
    const open = document.value;
    if (open === null || this.own === null) return;
    this.round.value = { kind: "hiding" };
    const goals = this.own.goals.map(({ name }) => name);
    while (goals.length > 0) {
      const [goal = ""] = goals.splice(drawn(goals.length), 1);
      const secret = written({ ...open.value, true_goal: goal } as typeof open.value);
      const ending = await this.way(secret);
      if (ending.kind === "stale" || this.round.value.kind !== "hiding") return;
      // A goal that can't be reached is not worth a guess.
      if (ending.kind !== "solved" || ending.outcome.plan === null) continue;
      this.hide(goal, ending.scene, ending.trace);
      return;
    }
    this.round.value = { kind: "impossible" };
  }

  /** The best way, or a good one where the best takes too long to wait for. */
  private async way(document: string): Promise<Ending> {
    const best = await this.patiently(document, "exact");
    if (best.kind !== "solved" || best.outcome.plan !== null || best.outcome.status !== "limit") return best;
    return this.patiently(document, "search");
  }

  private async patiently(document: string, solver: "exact" | "search"): Promise<Ending> {
    const timer = setTimeout(() => this.hider.cancel(), PATIENCE_MS);
    const ending = await this.hider.run({ kind: "solve", document, options: { solver } });
    clearTimeout(timer);
    return ending;
  }

  /** Says which goal the agent is after. */
  guess(guess: string): void {
    const { timeline } = this.playground;
    if (this.hidden === null || this.round.value.kind !== "guessing") return;
    const { goal, scene, trace } = this.hidden;
    const step = timeline.step.value;
    batch(() => {
      this.played.value += 1;
      if (guess === goal) this.right.value += 1;
      const possible = trace.steps[step]?.goals.adversarial.length ?? 0;
      this.round.value = { kind: "over", guess, goal, step, possible };
      this.playground.scene.value = scene;
      this.playground.showWalk("plan", trace, "end");
    });
  }

  /** Puts everything back as it was before the game. */
  leave(): void {
    this.end();
    this.playground.showResult();
  }

  /** The document has changed: the game is over, and what is shown is somebody else's. */
  end(): void {
    if (this.round.value.kind === "none") return;
    this.hider.drop();
    batch(() => {
      this.round.value = { kind: "none" };
      if (this.own !== null) this.playground.scene.value = this.own;
    });
    this.own = null;
    this.hidden = null;
  }

  dispose(): void {
    this.hider.dispose();
  }

  private hide(goal: string, scene: Scene, trace: Trace): void {
    this.hidden = { goal, scene, trace };
    batch(() => {
      this.round.value = { kind: "guessing" };
      // No view can tell which goal is the true one.
      this.playground.scene.value = { ...scene, true_goal: "" };
      this.playground.showWalk("guess", { ...trace, goal_difference: 0, steps: trace.steps.map(enemysView) }, "start");
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
