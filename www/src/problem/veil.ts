// A scene that is shown without what the observers believe, since a question that is still to be answered hides it.

const veiled = new WeakSet<object>();

export function veil<Scene extends object>(scene: Scene): Scene {
  const copy = { ...scene };
  veiled.add(copy);
  return copy;
}

export const isVeiled = (scene: object): boolean => veiled.has(scene);
