// The tools, always at hand above the boards, and what takes edits back.
import { html, type TemplateResult } from "lit";
import { type ToolStores, take, toolInHand, toolNames, toolsFor, useOf } from "../gesture/tools.js";
import type { Edits } from "../state/edits.js";
import { tools as icons } from "./icons.js";

export interface ToolbarStores extends ToolStores {
  edits: Edits;
}

export function toolbar(playground: ToolbarStores): TemplateResult | "" {
  const {
    problem,
    boards: { scene, mode },
  } = playground;
  const { history, canReset } = problem;
  if (scene.value === null) return "";
  const offered = toolsFor(scene.value.format, problem);
  const resting = mode.value !== "plan";
  const tool = toolInHand(playground);
  const act = (name: string, icon: TemplateResult, possible: boolean, action: () => void) =>
    html`<button type="button" class="tool" title=${name} aria-label=${name} aria-disabled=${String(!possible)}
      @click=${() => possible && action()}>${icon}<span aria-hidden="true">${name}</span></button>`;
  return html`<section class="toolbar" part="toolbar" aria-label="Editing">
    ${
      offered.length > 0
        ? html`<div class="tools" role="group" aria-label="Tools">
            ${offered.map((name) => {
              const { about, possible } = useOf(name, playground);
              return html`<button type="button" class="tool" aria-pressed=${String(name === tool)} title=${about}
                aria-disabled=${String(resting || !possible)} @click=${() => possible && (resting || take(playground, name))}>
                ${icons[name]}<span>${toolNames[name]}</span>
              </button>`;
            })}
          </div>`
        : ""
    }
    <div class="history" role="group" aria-label="Edits">
      ${act("Undo", icons.undo, history.canUndo.value, () => playground.edits.undo())}
      ${act("Redo", icons.redo, history.canRedo.value, () => playground.edits.redo())}
      ${act("Reset", icons.reset, canReset.value, () => playground.edits.reset())}
    </div>
    ${offered.length > 0 ? html`<p class="about ${tool}">${resting ? "The tools rest while a walk is shown." : useOf(tool, playground).about}</p>` : ""}
  </section>`;
}
