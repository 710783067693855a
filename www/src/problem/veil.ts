// A scene that is shown without what the observers believe, since a question that is still to be answered hides it.
import type { Scene } from "../core.js";

const veiled = new WeakSet<Scene>();

export function veil(scene: Scene): Scene {
  const copy = { ...scene };
  veiled.add(copy);
  return copy;
}

export const isVeiled = (scene: Scene): boolean => veiled.has(scene);
