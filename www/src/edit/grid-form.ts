// Editing a grid without the mouse: its size, whether the agent may stay, goals and observers.
import { html, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { setStay, symbolsOf } from "../problem/grid-sensor.js";
import { LARGEST_SIDE, resized, SMALLEST_SIDE } from "../problem/grid-size.js";
import type { GridworldDocument } from "../problem/types.js";
import { roles } from "../view/observers.js";
import { attempt, type FieldStores, lockNote, numberField } from "./fields.js";
import { goalsForm } from "./goals-form.js";
import { type ObserverFormStores, observerForm } from "./observer-form.js";

export function gridForm(playground: ObserverFormStores, document: GridworldDocument): TemplateResult {
  const size = lockNote(playground, ["width", "height", "stay"]);
  const isLocked = (key: string) => playground.problem.lockedAmong([key]).length > 0;
  return html`
    <fieldset>
      <legend>Grid</legend>
      ${size.note}
      <div class="row">
        ${side(playground, document, "width", "Columns")} ${side(playground, document, "height", "Rows")}
        <label class="check">
          <input type="checkbox" ?disabled=${isLocked("stay")} .checked=${live(document.stay === true)}
            @change=${(event: Event) =>
              attempt(playground, "stay", setStay(document, (event.target as HTMLInputElement).checked))} />
          <span>The agent may also stay where it is</span>
        </label>
      </div>
    </fieldset>
    ${goalsForm(playground, document)}
    <datalist id="${playground.workbench.id}-symbols">${symbolsOf(document).map((symbol) => html`<option value=${symbol}></option>`)}</datalist>
    ${roles.map((role) => observerForm(playground, document, role))}
  `;
}

function side(playground: FieldStores, document: GridworldDocument, key: "width" | "height", label: string) {
  const save = (value: number) => {
    const size = { width: document.width, height: document.height, [key]: value };
    const fitted = resized(document, size.width, size.height);
    if (typeof fitted === "string") return fitted;
    const { document: changed, changes } = fitted;
    playground.editing.note.value = { text: inWords(changes), document: changed };
    return changed;
  };
  return numberField(playground, {
    field: key,
    label,
    value: document[key],
    locked: playground.problem.lockedAmong([key]).length > 0,
    least: SMALLEST_SIDE,
    most: LARGEST_SIDE,
    save,
  });
}

function inWords(changes: readonly string[]): string {
  if (changes.length === 0) return "";
  const sentence = changes.join(", ");
  return `To fit, ${sentence}.`;
}
