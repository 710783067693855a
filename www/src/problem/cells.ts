// Cells of a grid, and lists of them.
import { times } from "./times.js";
import type { Cell } from "./types.js";

export interface Size {
  width: number;
  height: number;
}

/** How a cell is written in attributes, and compared. */
export const keyOf = ([column, row]: readonly [number, number]): string => `${column},${row}`;

/** A cell in words, counted as documents count: from 0, from the top left. */
export const cellText = ([column = 0, row = 0]: readonly number[]): string => `column ${column}, row ${row}`;

export const sameCell = (one: Cell, other: Cell): boolean => one[0] === other[0] && one[1] === other[1];

export const hasCell = (cells: readonly Cell[], cell: Cell): boolean => cells.some((other) => sameCell(other, cell));

export const without = (cells: readonly Cell[], cell: Cell): Cell[] => cells.filter((other) => !sameCell(other, cell));

export const inside = ({ width, height }: Size, [column, row]: Cell): boolean =>
  column >= 0 && row >= 0 && column < width && row < height;

/** Row by row. */
export const everyCell = ({ width, height }: Size): Cell[] =>
  times(width * height, (index) => [index % width, Math.floor(index / width)]);

/** Moves between two cells where nothing is in the way. */
export const distance = (one: Cell, other: Cell): number => Math.abs(one[0] - other[0]) + Math.abs(one[1] - other[1]);

/** The cells of a straight way from one cell to another, the first left out: a quick hand skips cells. */
export function between(from: Cell, to: Cell): Cell[] {
  const steps = Math.max(Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1]));
  const at = (start: number, end: number, step: number) => Math.round(start + ((end - start) * step) / steps);
  return times(steps, (index) => [at(from[0], to[0], index + 1), at(from[1], to[1], index + 1)]);
}
