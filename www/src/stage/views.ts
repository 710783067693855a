// The pictures that are loaded when they are needed: which one a problem gets.
import type { Scene } from "../core.js";
import { blocksKind, isBlocks } from "./blocks/kind.js";
import { boxPushingView } from "./box-pushing/view.js";
import { deliveryView } from "./delivery/view.js";
import { recyclingView } from "./recycling-robot/view.js";
import { factsKind, namesKind } from "./states/facts.js";
import { statesView } from "./states/view.js";
import { isTransport, transportKind } from "./transport/kind.js";
import type { View } from "./view.js";

const known = new WeakMap<Scene, View>();

export function viewOf(scene: Scene): View {
  const view = known.get(scene) ?? made(scene);
  known.set(scene, view);
  return view;
}

function made(scene: Scene): View {
  if (scene.format === "delivery") return deliveryView(scene);
  if (scene.format === "box-pushing") return boxPushingView(scene);
  if (scene.format === "recycling-robot") return recyclingView(scene);
  if (scene.format !== "pddl") return statesView(scene, namesKind());
  if (isBlocks(scene)) return statesView(scene, blocksKind(scene));
  if (isTransport(scene)) return statesView(scene, transportKind(scene));
  return statesView(scene, factsKind(scene));
}
