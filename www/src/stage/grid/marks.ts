// Marks that lie on many cells, each kind drawn as one path.

import type { State } from "../../core.js";
import { everyCell, type Size } from "../../problem/cells.js";
import type { OpenProblem } from "../../state/open-problem.js";
import type { BoardName } from "../board-input.js";
import { type Cell, cellOf, keyOf } from "./cells.js";

const DOT = 0.1;

/** The squares of cells. */
export const squares = (cells: readonly Cell[]): string =>
  cells.map(([column, row]) => `M${column + 0.03} ${row + 0.03}h.94v.94h-.94z`).join("");

let lastFloor: { size: Size; path: string } | null = null;

/** The squares of all cells; boards of one size share them. */
export function floorSquares({ width, height }: Size): string {
  if (lastFloor === null || lastFloor.size.width !== width || lastFloor.size.height !== height) {
    lastFloor = { size: { width, height }, path: squares(everyCell({ width, height })) };
  }
  return lastFloor.path;
}

/** A dot on every believed cell, so that it does not take colour to see them. */
export function dots(believed: readonly State[]): string {
  return believed
    .map((state) => {
      const [column, row] = cellOf(state);
      return `M${column + 0.5 - DOT} ${row + 0.5}a${DOT} ${DOT} 0 1 0 ${2 * DOT} 0a${DOT} ${DOT} 0 1 0 ${-2 * DOT} 0`;
    })
    .join("");
}

/** Corners around every free cell where the observer sees the agent exactly. */
export function cameraCorners(cameras: readonly Cell[], walls: readonly Cell[]): string {
  const walled = new Set(walls.map(keyOf));
  return cameras
    .filter((cell) => !walled.has(keyOf(cell)))
    .map(
      ([column, row]) =>
        `M${column + 0.1} ${row + 0.3}v-0.2h0.2M${column + 0.7} ${row + 0.1}h0.2v0.2M${column + 0.9} ${row + 0.7}v0.2h-0.2M${column + 0.3} ${row + 0.9}h-0.2v-0.2`,
    )
    .join("");
}

export function camerasOn(name: BoardName, { problem }: { problem: Pick<OpenProblem, "document"> }): readonly Cell[] {
  const value = problem.document.value?.value;
  if (name === "actor" || value?.format !== "gridworld") return [];
  return value.observers[name].cameras ?? [];
}
