// A solver at work: what it has looked at, the best so far, and how far the proof is.
import { html, type TemplateResult } from "lit";
import type { Progress } from "../core.js";
import { counted, differenceText, duration } from "../view/numbers.js";

export function work(progress: Progress | null, seconds: number, name: string): TemplateResult {
  return html`<div class="work">
    <progress aria-label=${name}></progress>
    <p>${progress === null ? "Solving…" : soFar(progress)} <span class="passed">${duration(Math.floor(seconds * 5) / 5)}</span></p>
  </div>`;
}

function soFar({ unit, done, horizon, goal_difference, bound, gap }: Progress): string {
  const parts = [`${counted(done, unit === "nodes" ? "node" : "state")} looked at`];
  if (horizon !== null) parts.push(`plans of ${counted(horizon, "move")}`);
  parts.push(goal_difference === null ? "no plan yet" : `best so far ${differenceText(goal_difference)}`);
  if (bound !== null) parts.push(`at most ${differenceText(bound)} possible`);
  if (gap !== null) parts.push(`gap ${differenceText(gap)}`);
  return `${parts.join(", ")}.`;
}
