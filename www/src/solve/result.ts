// What the solver is doing, or what it answered.
import { html, type TemplateResult } from "lit";
import type { Outcome, Progress, SolveOptions } from "../core.js";
import type { Playground, Result } from "../state/playground.js";
import { shortNumber, wholeNumber } from "../view/numbers.js";

export function result(playground: Playground): TemplateResult {
  const solving = playground.status.value === "solving" && playground.slow.value;
  const last = playground.result.value;
  // Only the answer is announced: progress changes many times a second.
  return html`<div class="result">
    ${solving ? working(playground.progress.value) : ""}
    <div role="status">${solving || last === null ? "" : answered(last)}</div>
  </div>`;
}

function working(progress: Progress | null): TemplateResult {
  return html`<progress aria-label="Solving"></progress>
    <p>${progress === null ? "Solving…" : soFar(progress)}</p>`;
}

function soFar({ unit, done, horizon, goal_difference, bound }: Progress): string {
  const parts = [`${wholeNumber(done)} ${unit === "nodes" ? "nodes" : "states"} looked at`];
  if (horizon !== null) parts.push(`plan length ${horizon}`);
  parts.push(goal_difference === null ? "no plan yet" : `best so far ${shortNumber(goal_difference)}`);
  if (bound !== null) parts.push(`at most ${shortNumber(bound)}`);
  return `${parts.join(", ")}.`;
}

const verdicts: Record<Outcome["status"], [title: string, meaning: string]> = {
  optimal: ["Proved optimal", "No such plan has a larger goal difference."],
  solved: ["Solved", "This plan keeps to what was asked; a better one may exist."],
  feasible: ["Best found", "Stopped before the proof; a better plan may exist."],
  infeasible: ["No plan", "It is proved that no plan does what was asked."],
  limit: ["Stopped", "No plan was found, and nothing is proved."],
};

function answered({ options, outcome }: Result): TemplateResult {
  const [title, meaning] = verdicts[outcome.status];
  return html`<p><b>${title}${scope(options, outcome)}.</b> ${length(options, outcome)}${meaning}</p>`;
}

const everyLength = (options: SolveOptions): boolean => options.solver === "exact" && options.horizon === undefined;

/** Among which plans it is the best: without that, "optimal" says too much. */
function scope(options: SolveOptions, { status, plan }: Result["outcome"]): string {
  if (status !== "optimal" || plan === null) return "";
  return ` among plans of ${everyLength(options) ? "every length" : moves(plan.length)}`;
}

/** How long the plan is, where the scope has not said so. */
function length(options: SolveOptions, { status, plan }: Result["outcome"]): string {
  if (plan === null || (status === "optimal" && !everyLength(options))) return "";
  return `${moves(plan.length)}. `;
}

const moves = (count: number): string => `${count} ${count === 1 ? "move" : "moves"}`;
