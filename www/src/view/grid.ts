// The parts of a scene that can be drawn as a grid.
import type { Scene, State } from "../core.js";

export type GridScene = Extract<Scene, { format: "gridworld" }>;
export type Cell = readonly [column: number, row: number];

export const isGrid = (scene: Scene): scene is GridScene => scene.format === "gridworld";

/** How a cell is written in attributes, and compared. */
export const keyOf = ([column, row]: Cell): string => `${column},${row}`;

/** A gridworld's state is the agent's cell. */
export function cellOf(state: State): Cell {
  const [column, row] = Array.isArray(state) ? state : [];
  return [Number(column), Number(row)];
}

export const keysOf = (states: readonly State[]): Set<string> => new Set(states.map((state) => keyOf(cellOf(state))));
