// Editing box pushing and the recycling robot: the goals here, what stands on the floor by hand on the boards.
import { html, type TemplateResult } from "lit";
import type { PoseDocument } from "../problem/types.js";
import type { FieldStores } from "./fields.js";
import { goalsForm } from "./goals-form.js";

const things: Record<PoseDocument["format"], string> = {
  "box-pushing": "the robot, the box and the goals",
  "recycling-robot": "the robot, the can, the charger and the bins",
};

export function poseForm(playground: FieldStores, document: PoseDocument): TemplateResult {
  return html`<p>Drag ${things[document.format]} on the boards, and walls on the agent’s; the tool Walls builds them.</p>
    ${goalsForm(playground, document)}
    <div class="actions">
      <button type="button" @click=${() => playground.workbench.open("document")}>Edit the rest as text</button>
      <small>The size, first beliefs and what each observer is told are edited in the document.</small>
    </div>`;
}
