// Which plan is on the boards, where it is not the solver's answer, and the way back.
import { html, nothing, type TemplateResult } from "lit";
import type { Boards } from "../state/boards.js";
import type { Plans } from "../state/plans.js";

export interface ShownPlanStores {
  boards: Boards;
  plans: Plans;
}

export function shownPlan(playground: ShownPlanStores): TemplateResult | typeof nothing {
  const title = playground.boards.chosen.value;
  if (title === null) return nothing;
  return html`<p class="shown-plan">On the boards: <b>${title}</b>.
    <button type="button" class="small" @click=${() => playground.plans.showAnswer()}>Back to the solver’s plan</button></p>`;
}
