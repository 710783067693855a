// The three boards in step: what the agent does, and what each observer makes of it.
import { html, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { beliefText } from "./belief-text.js";
import { type BoardName, board } from "./board.js";
import { boardCaption } from "./board-caption.js";
import { isGrid } from "./grid.js";

const titles: Record<BoardName, string> = {
  actor: "What the agent does",
  adversarial: "What the enemy believes",
  cooperative: "What the friend believes",
};

export function boards(playground: Playground): TemplateResult {
  const scene = playground.scene.value;
  const trace = playground.trace.value;
  const shown = playground.shown.value;
  const step = playground.step.value;
  if (scene === null || trace === null || shown === null) {
    return html`<p class="waiting">${playground.error.value === null ? "Loading…" : "There is nothing to show."}</p>`;
  }
  const drawing = (name: BoardName) =>
    isGrid(scene) ? board(name, { scene, trace, step, shown }) : beliefText(name, shown);
  return html`
    ${isGrid(scene) ? "" : html`<p class="note">Only gridworlds can be drawn yet; this problem is shown as text.</p>`}
    <div class="boards">
      ${(["actor", "adversarial", "cooperative"] as const).map(
        (name) => html`<figure class="panel ${name}">
          <figcaption>
            <h2>${titles[name]}</h2>
            <p>${boardCaption(name, playground)}</p>
          </figcaption>
          ${drawing(name)}
        </figure>`,
      )}
    </div>
  `;
}
