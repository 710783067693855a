// What the facts of a delivery's state say. The facts' words are the core's (src/domain/delivery/build.rs).
import type { Scene, State } from "../../core.js";
import type { BoardInput } from "../board-input.js";

export type DeliveryScene = Extract<Scene, { format: "delivery" }>;
export type DeliveryInput = BoardInput<DeliveryScene>;

/** Where the truck is: a factory by its place in the document, the yard, or the delivery area. */
export type TruckPlace = number | "yard" | "delivery area";

export const packagesOf = (scene: DeliveryScene): string[] => scene.factories.flatMap(({ packages }) => packages);

/** A delivery's states are the facts that hold. */
const holds = (state: State, fact: string): boolean => Array.isArray(state) && (state as string[]).includes(fact);

export const isLoaded = (state: State, name: string): boolean => holds(state, `${name} in the truck`);

export function truckPlace(scene: DeliveryScene, state: State): TruckPlace {
  if (holds(state, "truck in the yard")) return "yard";
  if (holds(state, "truck at the delivery area")) return "delivery area";
  return scene.factories.findIndex(({ name }) => holds(state, `truck at ${name}`));
}

/** In which part of the believed states each package is in the truck, from 0 to 1. */
export function loadedShares(scene: DeliveryScene, states: readonly State[]): Map<string, number> {
  const share = (name: string) => states.filter((state) => isLoaded(state, name)).length / Math.max(1, states.length);
  return new Map(packagesOf(scene).map((name) => [name, share(name)]));
}
