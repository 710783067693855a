// Which plan is on the boards, where it is not the solver's answer, and the way back.
import { html, nothing, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";

export function shownPlan(playground: Playground): TemplateResult | typeof nothing {
  const title = playground.chosen.value;
  if (title === null) return nothing;
  return html`<p class="shown-plan">On the boards: <b>${title}</b>.
    <button type="button" class="small" @click=${() => playground.showResult()}>Back to the solver’s plan</button></p>`;
}
