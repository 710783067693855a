// Until when a candidate goal is possible for an observer, and which symbol ends that.
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Trace } from "../core.js";
import { brief } from "../view/names.js";
import { called, type Role, roles } from "../view/observers.js";
import type { Timeline } from "./timeline.js";

/** What becomes of a goal for one observer. */
export type Fate =
  /** From this step on it is never possible again, by this symbol. */
  { kind: "ends"; step: number; symbol: string } | { kind: "possible" } | { kind: "never" };

/** A goal can be possible at some steps and not at others; this ends where it is possible for the last time before. */
export function fate(trace: Trace, goal: string, role: Role): Fate {
  let last = trace.steps.length - 1;
  while (last >= 0 && !trace.steps[last]?.goals[role].includes(goal)) last -= 1;
  if (last === -1) return { kind: "never" };
  const after = trace.steps[last + 1];
  if (after === undefined) return { kind: "possible" };
  return { kind: "ends", step: last + 1, symbol: after.symbols[role] ?? "" };
}

export class GoalStory {
  /** The goal that was chosen last. */
  readonly goal = signal<string | null>(null);

  /** What becomes of it, in words. */
  readonly sentence: ReadonlySignal<string>;

  constructor(private readonly timeline: Timeline) {
    this.sentence = computed(() => {
      const [goal, trace] = [this.goal.value, timeline.trace.value];
      return goal === null || trace === null ? "" : told(trace, goal);
    });
  }

  /** Shows the step from which the goal is not possible for an observer; chosen again, the step of the other. */
  choose(goal: string): void {
    const trace = this.timeline.trace.value;
    if (trace === null) return;
    const again = this.goal.value === goal;
    this.goal.value = goal;
    const steps = roles.flatMap((role) => this.endOf(goal, role) ?? []);
    const moments = [...new Set(steps)].sort((a, b) => a - b);
    const shown = this.timeline.step.value;
    const next = again ? moments.find((step) => step > shown) : undefined;
    const target = next ?? moments[0];
    if (target !== undefined) this.timeline.goTo(target);
  }

  /** Asks about a goal for one observer: where it is not possible, why at the step shown, and chosen again, at which step
   * that began; where it still is, until which step. */
  ask(goal: string, role: Role): void {
    const again = this.goal.value === goal;
    const possible = this.timeline.shown.value?.goals[role].includes(goal) ?? false;
    const end = this.endOf(goal, role);
    this.goal.value = goal;
    if ((again || possible) && end !== null) this.timeline.goTo(end);
  }

  /** From which step on a goal is not possible any more; null where it is possible at the end, or never was. */
  endOf(goal: string, role: Role): number | null {
    const trace = this.timeline.trace.value;
    const end = trace === null ? null : fate(trace, goal, role);
    return end?.kind === "ends" ? end.step : null;
  }

  forget(): void {
    this.goal.value = null;
  }
}

function told(trace: Trace, goal: string): string {
  const parts = roles.map((role) => {
    const end = fate(trace, goal, role);
    const who = `for the ${called[role]}`;
    if (end.kind === "never") return `${who} it is never possible`;
    if (end.kind === "possible") return `${who} it is possible at the end`;
    return `${who} it is possible until step ${end.step - 1}; “${brief(end.symbol)}” at step ${end.step} ends that`;
  });
  return `${brief(goal)}: ${parts.join("; ")}.`;
}
