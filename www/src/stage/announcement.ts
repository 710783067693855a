// The step, said once in words for those who do not see the boards.
import { html, type TemplateResult } from "lit";
import type { TraceStep } from "../core.js";
import type { Playground } from "../state/playground.js";
import { called, type Role } from "../view/observers.js";

export function announcement(playground: Playground): TemplateResult {
  const { said } = playground.editing;
  return html`<p class="unseen" aria-live="polite"><span>${sentence(playground)}</span> <span>${said.value}</span></p>`;
}

function sentence({ timeline, mode }: Playground): string {
  const shown = timeline.shown.value;
  // Playing would be a stream of words; the step it stops at is said.
  if (shown === null || timeline.playing.value) return "";
  const where = `Step ${timeline.step.value}${shown.action === null || mode.value === "guess" ? "" : `, ${shown.action}`}`;
  if (mode.value === "guess") return `${where}: ${part("adversarial", shown)}.`;
  return `${where}: ${part("adversarial", shown)}; ${part("cooperative", shown)}.`;
}

function part(role: Role, shown: TraceStep): string {
  const symbol = shown.symbols[role];
  const states = shown.beliefs[role].length;
  return [
    `the ${called[role]} ${symbol === null ? "has seen nothing yet" : `saw ${symbol}`}`,
    `${states} ${states === 1 ? "state" : "states"} left`,
    survive(shown.goals[role]),
  ].join(", ");
}

function survive(goals: readonly string[]): string {
  if (goals.length === 0) return "no goal survives";
  if (goals.length === 1) return `goal ${goals[0]} survives`;
  return `goals ${goals.slice(0, -1).join(", ")} and ${goals.at(-1)} survive`;
}
