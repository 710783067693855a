// What an observer of a delivery is told when something is loaded or delivered.
import { html, type TemplateResult } from "lit";
import {
  type DeliveryPreset,
  deliveryPresetOf,
  deliveryPresets,
  loadOf,
  setDeliverSymbol,
  setLoadSymbol,
  symbolFor,
  useDeliveryPreset,
} from "../problem/delivery-sensor.js";
import type { DeliveryDocument, Role } from "../problem/types.js";
import { called } from "../view/observers.js";
import { attempt, type FieldStores, lockNote, presetField, textField } from "./fields.js";

export function deliveryObserverForm(playground: FieldStores, document: DeliveryDocument, role: Role): TemplateResult {
  const load = loadOf(document, role);
  const symbol = (field: string, label: string, name: string, placeholder?: string) =>
    textField(playground, {
      field: `${role}-${field}`,
      label,
      value: symbolFor(load, name) ?? "",
      ...(placeholder === undefined ? {} : { placeholder }),
      save: (text) => setLoadSymbol(document, role, name, text),
    });
  const use = (name: DeliveryPreset) => attempt(playground, role, useDeliveryPreset(document, role, name));
  const { locked, note } = lockNote(playground, ["observers"]);
  return html`<fieldset class="observer ${role}" ?disabled=${locked}>
    <legend>What the ${called[role]} is told</legend>
    ${note}
    ${presetField("Sensor", deliveryPresets, deliveryPresetOf(document, role), use)}
    <div class="symbols-of" role="group" aria-label="Symbols for the ${called[role]}">
      ${
        typeof load === "string"
          ? row([symbol("every", "Any package", "")])
          : document.factories.map(({ name, packages }, index) =>
              row([
                symbol(`factory-${index}`, `Loading at ${name}`, name, "none"),
                ...packages.map((one, position) =>
                  symbol(`package-${index}-${position}`, `Loading ${one}`, one, symbolFor(load, name) ?? "needed"),
                ),
              ]),
            )
      }
      ${row([
        textField(playground, {
          field: `${role}-deliver`,
          label: "Delivering",
          value: document.observers[role].sensor.deliver,
          save: (text) => setDeliverSymbol(document, role, text),
        }),
      ])}
    </div>
    <small>A package without a symbol of its own has its factory’s. What has the same symbol looks the same to the ${called[role]}.</small>
  </fieldset>`;
}

const row = (fields: TemplateResult[]): TemplateResult => html`<div class="row moves">${fields}</div>`;
