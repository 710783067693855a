// The edit tab: everything of a problem that is not drawn by hand, by what kind of problem it is.
import { html, type TemplateResult } from "lit";
import { guard } from "lit/directives/guard.js";
import { newGrid } from "../problem/new-grid.js";
import { written } from "../problem/text.js";
import type { ProblemDocument } from "../problem/types.js";
import { isWhole } from "../view/long-list.js";
import { deliveryForm } from "./delivery-form.js";
import type { FieldStores } from "./fields.js";
import { gridForm } from "./grid-form.js";
import type { ObserverFormStores } from "./observer-form.js";
import { poseForm } from "./pose-form.js";

export type EditPanelStores = FieldStores & ObserverFormStores;

/** The usual size of the paper's gridworlds. */
const NEW_SIDE = 8;

export function editPanel(playground: EditPanelStores): TemplateResult {
  const {
    editing,
    problem: { latest },
  } = playground;
  const note = editing.note.value;
  // Steps come and go many times a second; they change nothing here.
  const form = guard([latest, editing.fault.value, note, isWhole(editing)], () => {
    if (latest?.format === "gridworld") return gridForm(playground, latest);
    if (latest?.format === "delivery") return deliveryForm(playground, latest);
    if (latest?.format === "box-pushing" || latest?.format === "recycling-robot") return poseForm(playground, latest);
    return asText(playground, latest?.format);
  });
  return html`<div class="edit">
    ${form}
    <p class="note" role="status">${note !== null && note.document === latest ? note.text : ""}</p>
    <div class="actions">
      <button type="button" @click=${() => playground.edits.open(written(newGrid(NEW_SIDE, NEW_SIDE)))}>New grid</button>
      <small>An empty grid of ${NEW_SIDE} by ${NEW_SIDE} cells with the paper’s observers. Undo brings this problem back.</small>
    </div>
  </div>`;
}

const asText = (playground: EditPanelStores, format: ProblemDocument["format"] | undefined): TemplateResult =>
  html`<p>${why[format ?? "explicit"] ?? why.explicit}</p>
    <div class="actions">
      <button type="button" class="primary" @click=${() => playground.workbench.open("document")}>Edit as text</button>
    </div>`;

const why: Partial<Record<ProblemDocument["format"], string>> = {
  explicit: "This problem lists its states one by one. It is edited as text.",
  pddl: "This problem is written in PDDL: domain, first state, goals and what each observer is told are edited as text.",
};
