// The candidate goals on the agent's board, where they can be drawn: small pictures with the marks of the grid's goals.

import { html, nothing, type TemplateResult } from "lit";
import { visible } from "../../problem/unseen.js";
import { star } from "../../view/icons.js";
import type { BoardInput } from "../board-input.js";
import { goalViews } from "../goal-attributes.js";
import { goalInWords, goalTold, marks } from "../goal-marks.js";
import type { StateKind } from "./kind.js";

/** More would be too small to read; the list beside the boards has them all. */
const MOST = 12;

export function goalCards({ scene, shown }: BoardInput, kind: StateKind): TemplateResult | typeof nothing {
  const drawn = kind.goals;
  if (drawn === undefined || scene.goals.length > MOST) return nothing;
  return html`<ul class="goal-cards" aria-label="Candidate goals">
    ${goalViews(scene, shown).map(
      (goal, index) =>
        html`<li class="goal-card" data-goal=${goal.name} data-adversarial=${goal.attributes.adversarial}
        data-cooperative=${goal.attributes.cooperative} ?data-true-goal=${goal.isTrue}
        title=${goalTold(goal)}>
        ${drawn(index)}
        <span class="name">${visible(goal.name)}</span>
        <svg class="marks" viewBox="-0.45 0.1 0.9 0.38" aria-hidden="true">${marks(goal, 0.22)}</svg>
        ${goal.isTrue ? star : nothing}
        <span class="unseen">${goalInWords(goal)}</span>
      </li>`,
    )}
  </ul>`;
}
