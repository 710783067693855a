// A delivery in words.
import { symbolFor } from "../../problem/delivery-sensor.js";
import type { DeliveryDocument, Role } from "../../problem/types.js";
import { roles } from "../../view/observers.js";
import { type InWords, listed, toldText, trueGoalText, who } from "./sensor.js";

export function deliveryInWords(document: DeliveryDocument): InWords {
  const { factories, deliver, true_goal } = document;
  const sentences = [
    ...factories.map(
      ({ name, packages }) =>
        `At the factory ${name} lie${packages.length === 1 ? "s" : ""} ${listed(packages) || "no packages"}.`,
    ),
    `The truck is empty at first. It loads ${deliver} of the packages, one after another, and then delivers them.`,
    `Goals: each set of ${deliver} packages.`,
    ...trueGoalText(true_goal),
  ];
  const told = roles.map((role) => toldOf(document, role));
  return { sentences, told: { sentences: ["The observers know what lies where at first.", ...told] } };
}

function toldOf({ factories, observers }: DeliveryDocument, role: Role): string {
  const { load, deliver } = observers[role].sensor;
  const symbolOf = (name: string, factory: string) => symbolFor(load, name) ?? symbolFor(load, factory) ?? "";
  const loads = factories.flatMap(({ name, packages }) =>
    packages.map((one) => [`load ${one}`, symbolOf(one, name)] as const),
  );
  const told = typeof load === "string" ? `“${load}” for every package that is loaded` : toldText(loads);
  return `${who(role)} is told ${told}; “${deliver}” for deliver.`;
}
