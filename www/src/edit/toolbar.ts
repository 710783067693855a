// The tools, always at hand above the boards, and what takes edits back.
import { html, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { tools as icons } from "./icons.js";
import { take, toolNames, tools } from "./tools.js";

export function toolbar(playground: Playground): TemplateResult | "" {
  const { history, editing, scene, canReset, mode } = playground;
  if (scene.value === null) return "";
  const isGrid = scene.value.format === "gridworld";
  const resting = mode.value !== "plan";
  const tool = editing.tool.value;
  const act = (name: string, icon: TemplateResult, possible: boolean, action: () => void) =>
    html`<button type="button" class="tool" title=${name} aria-label=${name} aria-disabled=${String(!possible)}
      @click=${() => possible && action()}>${icon}<span aria-hidden="true">${name}</span></button>`;
  return html`<section class="toolbar" aria-label="Editing">
    ${
      isGrid
        ? html`<div class="tools" role="group" aria-label="Tools">
            ${tools.map(
              (
                name,
              ) => html`<button type="button" class="tool" aria-pressed=${String(name === tool)} title=${toolNames[name].about}
                aria-disabled=${String(resting)} @click=${() => resting || take(playground, name)}>
                ${icons[name]}<span>${toolNames[name].title}</span>
              </button>`,
            )}
          </div>`
        : ""
    }
    <div class="history" role="group" aria-label="Edits">
      ${act("Undo", icons.undo, history.canUndo.value, () => playground.undo())}
      ${act("Redo", icons.redo, history.canRedo.value, () => playground.redo())}
      ${act("Reset", icons.reset, canReset.value, () => playground.reset())}
    </div>
    ${isGrid ? html`<p class="about ${tool}">${resting ? "The tools rest while a walk is shown." : toolNames[tool].about}</p>` : ""}
  </section>`;
}
