// Fields of the edit tab. What is typed is made an edit when the field is left; what can't be taken stays in the field,
// with the reason beside it, and the problem stays as it is.
import { html, nothing, type TemplateResult } from "lit";
import { LONGEST_NAME, tidied } from "../problem/names.js";
import type { ProblemDocument } from "../problem/types.js";
import type { Editing } from "../state/editing.js";
import type { Edits } from "../state/edits.js";
import { lockedText } from "../state/locks.js";
import type { OpenProblem } from "../state/open-problem.js";
import type { Workbench } from "../state/workbench.js";

export interface FieldStores {
  editing: Editing;
  problem: OpenProblem;
  edits: Edits;
  workbench: Workbench;
}

/** An edit, or why there can be none. */
export type Edited = ProblemDocument | string;

/** Why a form can't be used: parts of the document that it edits are locked. */
export function lockNote({ problem }: Pick<FieldStores, "problem">, keys: readonly string[]) {
  const locked = problem.lockedAmong(keys);
  return {
    locked: locked.length > 0,
    note: locked.length === 0 ? nothing : html`<p class="lock">${lockedText(locked)}</p>`,
  };
}

/** Makes an edit, or shows beside a field why not. Resolves to whether it was made. */
export function attempt(playground: FieldStores, field: string, edited: Edited, text = ""): boolean {
  const {
    editing,
    problem: { latest },
  } = playground;
  const refused = typeof edited === "string" ? edited : playground.edits.forbids(edited);
  if (typeof edited === "string" || refused !== null) {
    editing.fault.value = { field, text, message: refused ?? "", document: latest };
    return false;
  }
  editing.fault.value = null;
  if (edited !== latest) playground.edits.apply(edited);
  return true;
}

/** What was typed for the document that is open and could not be taken. */
function faultOf({ editing, problem: { latest } }: FieldStores, field: string) {
  const fault = editing.fault.value;
  return fault !== null && fault.field === field && fault.document === latest ? fault : null;
}

const faultId = ({ workbench }: Pick<FieldStores, "workbench">, field: string): string =>
  `${workbench.id}-fault-${field}`;

/** Why the last edit there could not be made. */
export function faultText(playground: FieldStores, field: string): TemplateResult | typeof nothing {
  const fault = faultOf(playground, field);
  return fault === null
    ? nothing
    : html`<p class="fault" id=${faultId(playground, field)} role="alert">${fault.message}</p>`;
}

interface TextField {
  /** Unique on the page. */
  field: string;
  label: string;
  /** The label is said, not shown. */
  bare?: boolean;
  value: string;
  placeholder?: string;
  /** The id of a list of suggestions. */
  list?: string;
  locked?: boolean;
  save: (text: string) => Edited;
}

export function textField(playground: FieldStores, options: TextField): TemplateResult {
  const { field, label, bare, value, placeholder, list, locked = false, save } = options;
  const fault = faultOf(playground, field);
  const change = (event: Event) => {
    const input = event.target as HTMLInputElement;
    if (attempt(playground, field, save(input.value), input.value)) input.value = tidied(input.value);
  };
  return html`<div class="field">
    <label>
      <span class=${bare ? "unseen" : ""}>${label}</span>
      <input type="text" autocomplete="off" spellcheck="false" maxlength=${LONGEST_NAME} name=${field} ?disabled=${locked}
        list=${list ?? nothing} placeholder=${placeholder ?? nothing} .value=${fault?.text ?? value}
        aria-invalid=${String(fault !== null)} aria-describedby=${fault === null ? nothing : faultId(playground, field)}
        @change=${change} @keydown=${leaveOnEnter} />
    </label>
    ${faultText(playground, field)}
  </div>`;
}

interface NumberField {
  field: string;
  label: string;
  value: number;
  locked?: boolean;
  least: number;
  most: number;
  save: (value: number) => Edited;
}

export function numberField(playground: FieldStores, options: NumberField): TemplateResult {
  const { field, label, value, locked = false, least, most, save } = options;
  const fault = faultOf(playground, field);
  const change = (event: Event) => {
    const { value: text, valueAsNumber } = event.target as HTMLInputElement;
    const fits = Number.isInteger(valueAsNumber) && valueAsNumber >= least && valueAsNumber <= most;
    attempt(playground, field, fits ? save(valueAsNumber) : `A whole number from ${least} to ${most}.`, text);
  };
  return html`<div class="field">
    <label>
      <span>${label}</span>
      <input type="number" min=${least} max=${most} step="1" name=${field} ?disabled=${locked} .value=${fault?.text ?? String(value)}
        aria-invalid=${String(fault !== null)} aria-describedby=${fault === null ? nothing : faultId(playground, field)}
        @change=${change} />
    </label>
    ${faultText(playground, field)}
  </div>`;
}

/** A choice of presets; an observer whose symbols are its own has none of them. */
export function presetField<Name extends string>(
  label: string,
  presets: Record<Name, string>,
  chosen: Name | null,
  choose: (name: Name) => void,
): TemplateResult {
  const names = Object.keys(presets) as Name[];
  return html`<label class="wide">
    <span>${label}</span>
    <select @change=${(event: Event) => choose((event.target as HTMLSelectElement).value as Name)}>
      ${chosen === null ? html`<option value="" selected disabled>Symbols of its own</option>` : nothing}
      ${names.map((name) => html`<option value=${name} ?selected=${name === chosen}>${presets[name]}</option>`)}
    </select>
  </label>`;
}

/** Enter makes the edit at once. */
function leaveOnEnter(event: KeyboardEvent): void {
  if (event.key !== "Enter") return;
  event.preventDefault();
  event.target?.dispatchEvent(new Event("change", { bubbles: true }));
}
