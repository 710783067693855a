// A large belief in words: what may hold, in how many of its states, and in how many each goal that is still possible.

import { html, nothing, type TemplateResult } from "lit";
import type { BeliefSummary, Scene, Share } from "../../core.js";
import { visible } from "../../problem/unseen.js";
import { counted, wholeNumber } from "../../view/numbers.js";
import type { StateKind } from "./kind.js";

/** Nobody reads more lines than these. */
const MANY = 200;

export const nameOf = (share: Share): string =>
  "fact" in share ? share.fact : `${share.part} ${Array.isArray(share.value) ? share.value.join(",") : share.value}`;

/** `few`: how many lines are there at once; the rest is one click away. */
export function summary(scene: Scene, kind: StateKind, belief: BeliefSummary, few: number): TemplateResult {
  const open = belief.shares.filter(({ states }) => states < belief.states);
  const certain = belief.shares.filter(({ states }) => states === belief.states);
  const line = (share: Share) =>
    html`<li>in <b>${wholeNumber(share.states)}</b> of them ${kind.words(nameOf(share))}</li>`;
  const rest = open.slice(few, MANY);
  const unsaid = open.length - few - rest.length + belief.left_out;
  return html`<div class="summary">
    <p><b>${wholeNumber(belief.states)}</b> states;</p>
    <ul>${open.slice(0, few).map(line)}</ul>
    ${goals(scene, belief)}
    ${
      rest.length > 0 || certain.length > 0
        ? html`<details><summary>More of what may be so</summary>
            <ul>${rest.map(line)}</ul>
            ${unsaid > 0 ? html`<p>and ${counted(unsaid, "more fact")} that ${unsaid === 1 ? "is" : "are"} not listed.</p>` : nothing}
            ${certain.length > 0 ? html`<p>In all of them: ${certain.slice(0, MANY).map((share, index) => html`${index === 0 ? "" : "; "}${kind.words(nameOf(share))}`)}.</p>` : nothing}
          </details>`
        : nothing
    }
  </div>`;
}

function goals(scene: Scene, belief: BeliefSummary): TemplateResult | typeof nothing {
  const held = scene.goals.map(({ name }, index) => ({ name, states: belief.goals[index] ?? 0 }));
  const alive = held.filter(({ states }) => states > 0).slice(0, MANY);
  if (alive.length === 0) return html`<p class="held">No goal holds in any of them.</p>`;
  return html`<p class="held">${alive.map(
    ({ name, states }, index) =>
      html`${index === 0 ? "" : ", "}<span class="name">${visible(name)}</span> holds in <b>${wholeNumber(states)}</b>`,
  )}.</p>`;
}
