// Editing box pushing and the recycling robot: the goals here, what stands on the floor by hand on the boards.
import { html, type TemplateResult } from "lit";
import type { PoseDocument } from "../problem/types.js";
import { type FieldStores, lockNote } from "./fields.js";
import { goalsForm } from "./goals-form.js";

/** What stands on the floor, by the keys of the document that say where. */
const things: Record<PoseDocument["format"], Record<string, string[]>> = {
  "box-pushing": { start: ["the robot", "the box"], goals: ["the goals"] },
  "recycling-robot": { start: ["the robot", "the can"], charger: ["the charger"], goals: ["the bins"] },
};

const listed = (names: readonly string[]): string =>
  names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`;

/** What can be dragged: what is not locked. */
function drags({ problem }: FieldStores, format: PoseDocument["format"]): string {
  const isFree = (key: string) => problem.lockedAmong([key]).length === 0;
  const free = Object.entries(things[format]).flatMap(([key, names]) => (isFree(key) ? names : []));
  const walls = isFree("walls") ? "walls on the agent’s; the tool Walls builds them" : "";
  if (free.length === 0) return walls === "" ? "" : `Drag ${walls}.`;
  return `Drag ${listed(free)} on the boards${walls === "" ? "" : `, and ${walls}`}.`;
}

export function poseForm(playground: FieldStores, document: PoseDocument): TemplateResult {
  return html`<p>${drags(playground, document.format)}</p>
    ${lockNote(playground, ["start", "charger", "walls"]).note}
    ${goalsForm(playground, document)}
    <div class="actions">
      <button type="button" @click=${() => playground.workbench.open("document")}>Edit the rest as text</button>
      <small>The size, first beliefs and what each observer is told are edited in the document.</small>
    </div>`;
}
