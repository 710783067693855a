// Where the mark of a goal stands: in the middle of its cell, or beside the others that share the cell.
import { keyOf, sameCell } from "../problem/cells.js";
import type { Cell } from "../problem/types.js";

export interface Place {
  x: number;
  y: number;
  scale: number;
}

/** Of the goals in these cells; `scale`: how large one is drawn that is alone. */
export function placesOf(cells: readonly Cell[], scale: number): Place[] {
  const together = new Map<string, number[]>();
  cells.forEach((cell, index) => {
    const key = keyOf(cell);
    together.set(key, [...(together.get(key) ?? []), index]);
  });
  return cells.map((cell, index) => {
    const sharing = together.get(keyOf(cell)) ?? [];
    return placed(cell, sharing.indexOf(index), sharing.length, scale);
  });
}

/** The place of one of `count` goals that share a cell. */
function placed(cell: Cell, rank: number, count: number, scale: number): Place {
  const columns = Math.floor(Math.sqrt(count));
  const rows = Math.ceil(count / columns);
  const share = (at: number, of: number, room: number) => ((at + 0.5) / of - 0.5) * room * scale;
  return {
    x: cell[0] + 0.5 + share(rank % columns, columns, 0.8),
    y: cell[1] + 0.5 + share(Math.floor(rank / columns), rows, 0.9),
    scale: scale * Math.min(1, 1.25 / rows, 1.1 / columns),
  };
}

/** The goal of the cell whose mark is nearest to a point; -1 where there is none. */
export function goalNear(cells: readonly Cell[], cell: Cell, point: { x: number; y: number }, scale: number): number {
  const sharing = cells.flatMap((other, index) => (sameCell(other, cell) ? [index] : []));
  let best = -1;
  let least = Number.POSITIVE_INFINITY;
  sharing.forEach((index, rank) => {
    const { x, y } = placed(cell, rank, sharing.length, scale);
    const away = Math.hypot(x - point.x, y - point.y);
    if (away < least) [best, least] = [index, away];
  });
  return best;
}

/** Around the goals of a cell there is room for the ring of the start, which is drawn, and grasped, this far out. */
export const RING = 0.46;
