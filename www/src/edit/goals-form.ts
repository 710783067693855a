// The candidate goals of a grid: their names, which is true, and how many there are.
import { html, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { cellText } from "../problem/cells.js";
import { addGoal, chooseTrueGoal, removeGoal, renameGoal } from "../problem/grid-goals.js";
import type { FloorDocument } from "../problem/types.js";
import { inTurns } from "../view/in-turns.js";
import { longList } from "../view/long-list.js";
import { attempt, type FieldStores, faultText, lockNote, textField } from "./fields.js";
import { cross } from "./icons.js";

export function goalsForm(playground: FieldStores, document: FloorDocument): TemplateResult {
  const list = longList(playground.editing, document.goals, "goals", ({ name }) => name === document.true_goal);
  const { problem } = playground;
  const isLocked = (...keys: string[]) => problem.lockedAmong(keys).length > 0;
  // What is true is known by its name: a change of either is one of both.
  const ofGoal = (name: string) => (name === document.true_goal ? ["goals", "true_goal"] : ["goals"]);
  return html`<fieldset>
    <legend>Candidate goals</legend>
    ${lockNote(playground, ["goals", "true_goal"]).note}
    <small>The enemy and the friend know them all; only the agent knows which one is true.</small>
    <ul class="entries">
      ${inTurns(
        list.shown,
        ({
          item: {
            name,
            cell: [column, row],
          },
          index,
        }) => html`<li>
          <label class="check">
            <input type="radio" name=${`${playground.workbench.id}-true-goal`} .checked=${live(name === document.true_goal)} aria-label=${`${name} is the true goal`} ?disabled=${isLocked("true_goal")}
              @change=${() => attempt(playground, "goals", chooseTrueGoal(document, index))} />
            <span aria-hidden="true">true</span>
          </label>
          ${textField(playground, {
            field: `goal-${index}`,
            label: `Name of goal ${index + 1}`,
            bare: true,
            value: name,
            locked: isLocked(...ofGoal(name)),
            save: (text) => renameGoal(document, index, text),
          })}
          <span class="where">${cellText([column, row])}</span>
          <button type="button" class="sign" aria-label=${`Remove ${name}`} title="Remove" ?disabled=${isLocked(...ofGoal(name))} @click=${(
            event: Event,
          ) => {
            focusBefore(event);
            attempt(playground, "goals", removeGoal(document, index));
          }}>${cross}</button>
        </li>`,
      )}
    </ul>
    ${list.more}
    ${faultText(playground, "goals")}
    <div class="actions">
      <button type="button" ?disabled=${isLocked("goals")} @click=${() => attempt(playground, "goals", addGoal(document))}>Add a goal</button>
      ${isLocked("goals") ? "" : html`<small>Drag it on a board to where it belongs.</small>`}
    </div>
  </fieldset>`;
}

/** The button of the last entry goes with it: the one before takes the focus, so that the keyboard stays there. */
export function focusBefore(event: Event): void {
  const entry = (event.currentTarget as Element).closest("li");
  if (entry === null || entry.nextElementSibling !== null) return;
  entry.previousElementSibling?.querySelector<HTMLElement>("button.sign")?.focus();
}
