// The controls of a walk: what can be done now, a step back, and how the walk compares with the best of its length.
import { html, type TemplateResult } from "lit";
import type { Scene } from "../core.js";
import type { Boards } from "../state/boards.js";
import type { Timeline } from "../state/timeline.js";
import type { Verdict, Walk } from "../state/walk.js";
import { shortNumber } from "../view/numbers.js";
import { chooser } from "./chooser.js";
import { arrows } from "./walk-keys.js";

export interface WalkPanelStores {
  walk: Walk;
  boards: Boards;
  timeline: Timeline;
}

const hints: Partial<Record<Scene["format"], string>> = {
  gridworld: "Use the arrow keys on the agent's board, click a cell beside the agent, or these buttons.",
  "box-pushing":
    "Use the keys on the agent's board (up: move forward, left and right: turn, S: stay), or these buttons.",
  "recycling-robot":
    "Use the keys on the agent's board (arrows, P: pick up, D: drop, C: charge, S: stay), or these buttons.",
};

export function walkPanel(playground: WalkPanelStores): TemplateResult {
  const walk = playground.walk;
  const format = playground.boards.scene.value?.format;
  const grid = format === "gridworld";
  const { step } = playground.timeline;
  return html`<div class="play walk">
    <p>${(format !== undefined && hints[format]) || "Choose what to do next."} Reach the true goal, marked with a star.</p>
    ${grid ? pad(walk) : chooser(walk)}
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
