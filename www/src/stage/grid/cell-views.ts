// What is to be drawn in each cell of a board.
import type { Playground } from "../../state/playground.js";
import type { BoardName } from "../board-input.js";
import { type GridInput, keyOf, keysOf } from "./cells.js";

export interface CellView {
  key: string;
  column: number;
  row: number;
  wall: boolean;
  believed: boolean;
  /** Here this board's observer sees the agent exactly. */
  camera: boolean;
}

export function cellViews(name: BoardName, { scene, shown }: GridInput, playground: Playground): CellView[] {
  const walls = new Set(scene.walls.map(keyOf));
  const believed = name === "actor" ? new Set<string>() : keysOf(shown.beliefs[name]);
  const cameras = new Set(camerasOf(name, playground).map(keyOf));
  const views: CellView[] = [];
  for (let row = 0; row < scene.height; row += 1) {
    for (let column = 0; column < scene.width; column += 1) {
      const key = `${column},${row}`;
      views.push({
        key,
        column,
        row,
        wall: walls.has(key),
        believed: believed.has(key),
        camera: cameras.has(key),
      });
    }
  }
  return views;
}

function camerasOf(name: BoardName, { document }: Playground) {
  const value = document.value?.value;
  if (name === "actor" || value?.format !== "gridworld") return [];
  return value.observers[name].cameras ?? [];
}
