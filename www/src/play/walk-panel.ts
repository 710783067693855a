// The controls of a walk: what can be done now, a step back, and how the walk compares with the best of its length.
import { html, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import type { Verdict, Walk } from "../state/walk.js";
import { shortNumber } from "../view/numbers.js";
import { arrows } from "./walk-keys.js";

/** More buttons than these are a list. */
const MANY = 12;

export function walkPanel(playground: Playground): TemplateResult {
  const walk = playground.walker;
  const grid = playground.scene.value?.format === "gridworld";
  const { step } = playground.timeline;
  return html`<div class="play walk">
    <p>${
      grid
        ? "Use the arrow keys on the agent's board, click a cell beside the agent, or these buttons."
        : "Choose what to do next."
    } Reach the true goal, marked with a star.</p>
    ${grid ? pad(walk) : list(walk)}
    <div class="actions">
      <button type="button" ?disabled=${step.value === 0} @click=${() => void walk.back()}>Take back a step</button>
      <button type="button" ?disabled=${step.value === 0} @click=${() => void walk.start()}>Start over</button>
      <button type="button" @click=${() => walk.leave()}>Stop walking</button>
    </div>
    <div role="status" class="result">
      ${walk.message.value === "" ? "" : html`<p>${walk.message.value}</p>`} ${judged(walk, walk.verdict.value)}
    </div>
  </div>`;
}

/** A cross of buttons, for a finger. */
function pad(walk: Walk): TemplateResult {
  const possible = new Set(walk.next.value.map(({ action }) => action));
  const names = [...Object.values(arrows).map(({ action }) => action), ...(possible.has("stay") ? ["stay"] : [])];
  return html`<div class="pad">
    ${names.map(
      (action) => html`<button type="button" class="sign main ${action}" aria-label=${action} title=${action}
        aria-disabled=${String(!possible.has(action))} @click=${() => void walk.take(action)}>${
          Object.values(arrows).find((arrow) => arrow.action === action)?.sign ?? "·"
        }</button>`,
    )}
  </div>`;
}

function list(walk: Walk): TemplateResult {
  const next = walk.next.value;
  if (next.length === 0) return html`<p>There is nothing left to do.</p>`;
  return html`<ul class="next ${next.length > MANY ? "many" : ""}" aria-label="What can be done now">
    ${next.map(
      ({ action }) => html`<li><button type="button" @click=${() => void walk.take(action)}>${action}</button></li>`,
    )}
  </ul>`;
}

function judged(walk: Walk, verdict: Verdict): TemplateResult | string {
  if (verdict.kind === "walking") return "";
  const you = `You: ${shortNumber(verdict.difference)} in ${verdict.moves} ${verdict.moves === 1 ? "action" : "actions"}.`;
  if (verdict.kind === "comparing") return html`<p>${you} Looking for the best of that length…</p>`;
  const best = verdict.best.goal_difference;
  if (best === null) return html`<p>${you}</p>`;
  if (verdict.best.status !== "optimal") {
    return html`<p>${you} The best found with as many: ${shortNumber(best)}.</p>`;
  }
  if (best <= verdict.difference) return html`<p><b>${you}</b> No plan of that length does better.</p>`;
  return html`<p><b>${you}</b> The best with as many: <b>${shortNumber(best)}</b>.
    <button type="button" class="link" @click=${() => void walk.showBest()}>Show it</button></p>`;
}
