// What can be done at the step shown of a walk, as buttons. They stand under the agent's board, where the walk is seen.
import { html, type TemplateResult } from "lit";
import type { Boards } from "../state/boards.js";
import type { Walk } from "../state/walk.js";
import { chooser } from "./chooser.js";
import { arrows } from "./walk-keys.js";

export interface WalkControlStores {
  walk: Walk;
  boards: Boards;
}

export function walkControls({ walk, boards }: WalkControlStores): TemplateResult {
  return html`<div class="walk-controls">${boards.scene.value?.format === "gridworld" ? pad(walk) : chooser(walk)}</div>`;
}

/** A row of arrows, for a finger. */
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
