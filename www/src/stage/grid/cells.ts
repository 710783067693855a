// The parts of a scene that can be drawn as a grid.
import type { Scene, State } from "../../core.js";
import { keyOf } from "../../problem/cells.js";
import type { Cell } from "../../problem/types.js";
import type { BoardInput } from "../board-input.js";

export type { Cell };
export { keyOf };
export type GridScene = Extract<Scene, { format: "gridworld" }>;
export type GridInput = BoardInput<GridScene>;

export const isGrid = (scene: Scene): scene is GridScene => scene.format === "gridworld";

/** A gridworld's state is the agent's cell. */
export function cellOf(state: State): Cell {
  const [column, row] = Array.isArray(state) ? state : [];
  return [Number(column), Number(row)];
}

export const keysOf = (states: readonly State[]): Set<string> => new Set(states.map((state) => keyOf(cellOf(state))));
