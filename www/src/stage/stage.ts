// The stage: the agent in the middle, the enemy on one side and the friend on the other, all at the same step.
import { html, nothing, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import type { BoardName } from "./board-input.js";
import { goalDifference } from "./goal-difference.js";
import { panelHead } from "./panel-head.js";
import { picture } from "./picture.js";
import { survivors } from "./survivors.js";
import { symbols } from "./symbols.js";

const boardNames: readonly BoardName[] = ["actor", "adversarial", "cooperative"];

export function stage(playground: Playground): TemplateResult {
  const scene = playground.scene.value;
  const { trace, shown, step } = playground.timeline;
  if (scene === null || trace.value === null || shown.value === null) {
    return html`<p class="waiting">${playground.error.value === null ? "Loading…" : "There is nothing to show."}</p>`;
  }
  const input = { scene, trace: trace.value, step: step.value, shown: shown.value };
  const guessing = playground.mode.value === "guess";
  return html`<div class="stage">
    ${boardNames.map((name) => {
      const hidden = guessing && name !== "adversarial";
      return html`<figure class="panel ${name}" data-hidden=${hidden || nothing}>
        <figcaption>${panelHead(name, playground)} ${hidden ? nothing : symbols(name, playground)}</figcaption>
        ${hidden ? html`<p class="covered">Covered while you are the enemy.</p>` : picture(name, input, playground)}
        <div class="verdict">
          ${hidden ? nothing : name === "actor" ? goalDifference(playground) : survivors(name, input)}
        </div>
      </figure>`;
    })}
  </div>`;
}
