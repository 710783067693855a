// Editing a delivery: factories and their packages, what is delivered, and what the observers can tell apart.
import { html, type TemplateResult } from "lit";
import { guard } from "lit/directives/guard.js";
import {
  goalSets,
  JOINT,
  packagesOf,
  possibleNumbers,
  setCount,
  setDeliver,
  trueGoalOf,
  withTrueGoal,
} from "../problem/delivery-goals.js";
import {
  addFactory,
  addPackage,
  removeFactory,
  removePackage,
  renameFactory,
  renamePackage,
} from "../problem/delivery-places.js";
import type { DeliveryDocument } from "../problem/types.js";
import { roles } from "../view/observers.js";
import { deliveryObserverForm } from "./delivery-observer.js";
import { attempt, type Edited, type FieldStores, faultText, lockNote, textField } from "./fields.js";
import { focusBefore } from "./goals-form.js";
import { cross } from "./icons.js";

export function deliveryForm(playground: FieldStores, document: DeliveryDocument): TemplateResult {
  return html`
    ${document.factories.map((factory, index) => factoryForm(playground, document, factory, index))}
    <div class="actions">
      <button type="button" ?disabled=${lockNote(playground, ["factories"]).locked} @click=${() => attempt(playground, "factories", addFactory(document))}>Add a factory</button>
    </div>
    ${faultText(playground, "factories")} ${whatToDeliver(playground, document)}
    ${roles.map((role) => deliveryObserverForm(playground, document, role))}
  `;
}

function factoryForm(
  playground: FieldStores,
  document: DeliveryDocument,
  { name, packages }: DeliveryDocument["factories"][number],
  index: number,
): TemplateResult {
  const field = `factory-${index}`;
  const edit = (edited: Edited) => attempt(playground, `${field}-packages`, edited);
  const { locked, note } = lockNote(playground, ["factories"]);
  return html`<fieldset ?disabled=${locked}>
    <legend>Factory ${name}</legend>
    ${note}
    <div class="row">
      ${textField(playground, { field, label: "Name of the factory", value: name, save: (text) => renameFactory(document, index, text) })}
      <button type="button" @click=${() => edit(removeFactory(document, index))}>Remove the factory</button>
    </div>
    <ul class="entries short" aria-label="Packages at ${name}">
      ${packages.map(
        (one, position) => html`<li>
          ${textField(playground, {
            field: `package-${index}-${position}`,
            label: `Name of package ${position + 1} at ${name}`,
            bare: true,
            value: one,
            save: (text) => renamePackage(document, one, text),
          })}
          <button type="button" class="sign" aria-label=${`Remove ${one}`} title="Remove" @click=${(event: Event) => {
            focusBefore(event);
            edit(removePackage(document, one));
          }}>${cross}</button>
        </li>`,
      )}
    </ul>
    ${faultText(playground, `${field}-packages`)}
    <div class="actions">
      <button type="button" @click=${() => edit(addPackage(document, index))}>Add a package at ${name}</button>
    </div>
  </fieldset>`;
}

function whatToDeliver(playground: FieldStores, document: DeliveryDocument): TemplateResult {
  const all = packagesOf(document).length;
  const chosen = trueGoalOf(withTrueGoal(document, trueGoalOf(document))).join(JOINT);
  const value = (event: Event) => (event.target as HTMLSelectElement).value;
  const { locked, note } = lockNote(playground, ["deliver", "true_goal"]);
  return html`<fieldset ?disabled=${locked}>
    <legend>What is delivered</legend>
    ${note}
    <div class="row">
      <label>
        <span>Packages at once</span>
        <select @change=${(event: Event) => attempt(playground, "deliver", setDeliver(document, Number(value(event))))}>
          ${possibleNumbers(all).map(
            (number) => html`<option value=${number} ?selected=${number === document.deliver}>
              ${number} of ${all} (${setCount(all, number)} candidate goals)
            </option>`,
          )}
        </select>
      </label>
      <label>
        <span>True goal</span>
        <select @change=${(event: Event) => attempt(playground, "deliver", withTrueGoal(document, value(event).split(JOINT)))}>
          ${guard([document], () =>
            goalSets(document).map((set) => {
              const name = set.join(JOINT);
              return html`<option value=${name} ?selected=${name === chosen}>${set.join(" and ")}</option>`;
            }),
          )}
        </select>
      </label>
    </div>
    <small>Every set of that many packages is a candidate goal; the true one is what the truck really delivers.</small>
  </fieldset>`;
}
