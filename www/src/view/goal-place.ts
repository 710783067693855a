// Where the mark of a goal stands: in the middle of its cell, or beside the others that share the cell.
import { sameCell } from "../problem/cells.js";
import type { Cell } from "../problem/types.js";

export interface Place {
  x: number;
  y: number;
  scale: number;
}

/** Of the goal with this index, among goals in these cells; `scale`: how large one is drawn that is alone. */
export function placeOf(cells: readonly Cell[], index: number, scale: number): Place {
  const cell = cells[index] ?? [0, 0];
  const together = cells.flatMap((other, at) => (sameCell(other, cell) ? [at] : []));
  const columns = Math.floor(Math.sqrt(together.length));
  const rows = Math.ceil(together.length / columns);
  const rank = together.indexOf(index);
  const share = (at: number, of: number, room: number) => ((at + 0.5) / of - 0.5) * room * scale;
  return {
    x: cell[0] + 0.5 + share(rank % columns, columns, 0.8),
    y: cell[1] + 0.5 + share(Math.floor(rank / columns), rows, 0.9),
    scale: scale * Math.min(1, 1.25 / rows, 1.1 / columns),
  };
}

/** The goal of the cell whose mark is nearest to a point; -1 where there is none. */
export function goalNear(cells: readonly Cell[], cell: Cell, point: { x: number; y: number }, scale: number): number {
  let best = -1;
  let least = Number.POSITIVE_INFINITY;
  cells.forEach((other, index) => {
    if (!sameCell(other, cell)) return;
    const { x, y } = placeOf(cells, index, scale);
    const away = Math.hypot(x - point.x, y - point.y);
    if (away < least) [best, least] = [index, away];
  });
  return best;
}

/** Around the goals of a cell there is room for the ring of the start, which is drawn, and grasped, this far out. */
export const RING = 0.46;
