// What the boards show: whose steps they are, and of which scene.
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Scene, Trace } from "../core.js";
import { veil } from "../problem/veil.js";
import { GoalStory } from "./goal-story.js";
import type { OpenProblem } from "./open-problem.js";
import type { At, Timeline } from "./timeline.js";

/** Whose steps are shown: a plan's, or those of the person who walks, or those that the person sees as the enemy. */
export type Mode = "plan" | "walk" | "guess";

export class Boards {
  readonly mode = signal<Mode>("plan");
  /** What the plan shown is, where it is not the result: "a plan of the trade-off". */
  readonly chosen = signal<string | null>(null);
  /** What a game shows in place of the open problem; without its document, where that would tell what is to be guessed. */
  readonly disguise = signal<{ scene: Scene; document: string | null } | null>(null);
  readonly scene: ReadonlySignal<Scene | null>;
  /** The text of the document whose steps are shown; null where there is none, or it is kept secret. */
  readonly document: ReadonlySignal<string | null>;
  readonly story: GoalStory;
  /** The goal difference at the end of the plan shown; null while there is none. */
  readonly difference: ReadonlySignal<number | null>;
  /** The step shown is the end of a plan for the true goal: a goal difference is of that, and of no step before. */
  readonly ended: ReadonlySignal<boolean>;
  /** They are told when the answer of a solver takes the place of what was shown. */
  readonly replaced = new Set<() => void>();
  private readonly hasPlan = signal(false);
  /** The step of the answer that was shown when a game began. */
  private left: number | null = null;
  private readonly timeline: Timeline;

  constructor({
    problem,
    timeline,
  }: { problem: Pick<OpenProblem, "document" | "scene" | "veiled">; timeline: Timeline }) {
    this.timeline = timeline;
    this.story = new GoalStory(timeline);
    this.scene = computed(() => {
      const scene = this.disguise.value?.scene ?? problem.scene.value;
      return scene !== null && problem.veiled.value ? veil(scene) : scene;
    });
    this.document = computed(() => {
      const disguise = this.disguise.value;
      return disguise === null ? (problem.document.value?.text ?? null) : disguise.document;
    });
    this.difference = computed(() => {
      if (this.mode.value === "guess") return null;
      const trace = timeline.trace.value;
      return trace?.valid && this.hasPlan.value ? trace.goal_difference : null;
    });
    this.ended = computed(() => this.difference.value !== null && timeline.step.value === timeline.lastStep.value);
  }

  /** Shows what a solver answered, or the start while it has not: whatever was played is over. */
  showAnswer(trace: Trace, hasPlan: boolean, at: At): void {
    this.left = null;
    batch(() => {
      for (const told of this.replaced) told();
      this.show("plan", null, hasPlan);
      this.timeline.show(trace, at);
    });
  }

  /** Shows the answer again, after a game at the step that was shown before it; `trace` is null where there was none. */
  showAnswerAgain(trace: Trace | null, hasPlan: boolean): void {
    const step = this.left;
    this.left = null;
    batch(() => {
      this.show("plan", null, hasPlan);
      this.timeline.pause();
      if (trace === null) return;
      this.timeline.show(trace, step === 0 ? "first" : "end");
      if (step !== null && step > 0) this.timeline.goTo(step);
    });
  }

  /** Shows the steps of another plan; `title` says whose. */
  showPlan(trace: Trace, title: string, at: "first" | "end"): void {
    this.showSteps("plan", trace, at, title);
  }

  /** Shows steps that are no solver's, in the mode they belong to. */
  showSteps(mode: Mode, trace: Trace, at: At, title: string | null = null): void {
    if (mode !== "plan" && this.mode.value === "plan" && this.chosen.value === null)
      this.left ??= this.timeline.step.value;
    batch(() => {
      this.show(mode, title, true);
      this.timeline.pause();
      this.timeline.show(trace, at);
    });
  }

  private show(mode: Mode, title: string | null, hasPlan: boolean): void {
    this.mode.value = mode;
    this.chosen.value = title;
    this.hasPlan.value = hasPlan;
  }
}
