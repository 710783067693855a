// The way back to the question of a problem that was opened without it.
import { html, nothing, type TemplateResult } from "lit";
import type { Edits } from "../state/edits.js";
import { partName } from "../state/locks.js";
import type { OpenProblem } from "../state/open-problem.js";

interface WayBackStores {
  problem: Pick<OpenProblem, "closed" | "question" | "veiled">;
  edits: Pick<Edits, "returnToExercise">;
}

export function wayBack({ problem, edits }: WayBackStores): TemplateResult | typeof nothing {
  const question = problem.question.value;
  if (question === null) return nothing;
  return html`<div class="way-back">
    <button type="button" @click=${() => void edits.returnToExercise()}>Back to the question</button>
    <p>This is the problem of a question.${lockedText(question.locked)}${
      problem.closed.value ? " Solvers and best values are kept back until the question is answered." : ""
    }${problem.veiled.value ? " So is what the enemy and the friend believe." : ""}</p>
  </div>`;
}

const lockedText = (keys: readonly string[]): string =>
  keys.length === 0 ? "" : ` Locked in it: ${keys.map(partName).join(", ")}.`;
