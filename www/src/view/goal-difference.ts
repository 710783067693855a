// The goal difference at the step shown, and what it is made of.
import { html, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { shortNumber } from "./numbers.js";

export function goalDifference(playground: Playground): TemplateResult | "" {
  const scene = playground.scene.value;
  const shown = playground.shown.value;
  if (scene === null || shown === null) return "";
  const { adversarial, cooperative } = shown.goals;
  const value = shortNumber(shown.goal_difference);
  const final = playground.result.value?.outcome.goal_difference ?? null;
  const atEnd = playground.step.value === playground.lastStep.value;
  return html`<div class="difference">
    <p class="value">Goal difference <b>${value}</b></p>
    <p>
      <b class="enemy">${adversarial.length}</b> for the enemy − <b class="friend">${cooperative.length}</b> for the
      friend, over ${scene.goals.length} − 1 = <b>${value}</b>
    </p>
    ${final === null || atEnd ? "" : html`<p class="final">When the plan ends it is ${shortNumber(final)}.</p>`}
  </div>`;
}
