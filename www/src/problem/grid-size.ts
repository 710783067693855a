// Making a grid larger or smaller.
import { cellText, distance, everyCell, hasCell, inside, keyOf, sameCell } from "./cells.js";
import { beliefOf, camerasOf, freeCells, wallsOf, withBelief, withCameras } from "./grid-cells.js";
import type { Cell, GridworldDocument, Role } from "./types.js";

export const SMALLEST_SIDE = 2;
export const LARGEST_SIDE = 32;

const roles: readonly Role[] = ["adversarial", "cooperative"];

export interface Resized {
  document: GridworldDocument;
  /** What had to give way, in words; empty where everything fitted. */
  changes: string[];
}

/**
 * Keeps what fits. The start and the goals move to the nearest cells that are free, each to one of its own; the rest
 * vanishes with its cells. Where there are too few cells, a sentence says so.
 */
export function resized(document: GridworldDocument, width: number, height: number): Resized | string {
  const size = { width, height };
  const fits = (cell: Cell) => inside(size, cell);
  const walls = wallsOf(document).filter(fits);
  const changes: string[] = [];
  // A wall that fills all that is left would leave no place to be.
  const open = freeCells({ ...document, ...size, walls });
  const free = open.length > 0 ? open : everyCell(size).slice(0, 1);
  const kept = walls.filter((wall) => !free.some((cell) => sameCell(cell, wall)));
  const cells = document.goals.map(({ cell }) => cell);
  let places = newPlaces([document.start, ...cells], free);
  const crowded = typeof places === "string";
  // Where there is no cell left over for the start, it can be on a goal's.
  if (crowded) places = newPlaces(cells, free);
  if (typeof places === "string") return places;
  if (crowded) places.set(keyOf(document.start), nearest(free, document.start));
  const found = places;
  const moved = (cell: Cell): Cell => found.get(keyOf(cell)) ?? cell;

  const start = moved(document.start);
  const goals = document.goals.map((goal) => ({ ...goal, cell: moved(goal.cell) }));
  let result: GridworldDocument = { ...document, ...size, start, goals };
  if (document.walls !== undefined) result.walls = kept;
  for (const role of roles) {
    const belief = beliefOf(document, role).filter((cell) => free.some((other) => sameCell(other, cell)));
    const held = belief.some((cell) => sameCell(cell, start)) ? belief : [start, ...belief];
    result = withCameras(withBelief(result, role, held), role, camerasOf(document, role).filter(fits));
  }

  const met = crowded ? goals.find(({ cell }) => sameCell(cell, start)) : undefined;
  const where = `${cellText(start)}${met === undefined ? "" : `, where ${met.name} is`}`;
  if (!sameCell(start, document.start)) changes.push(`the start moved to ${where}`);
  else if (met !== undefined) changes.push(`${met.name} is where the start is`);
  goals.forEach(({ name, cell }, index) => {
    if (!sameCell(cell, document.goals[index]?.cell ?? cell)) changes.push(`${name} moved to ${cellText(cell)}`);
  });
  const lost = wallsOf(document).length - kept.length;
  if (lost > 0) changes.push(lost === 1 ? "one wall vanished" : `${lost} walls vanished`);
  return { document: result, changes };
}

/** Where each cell of `taken` comes to lie among those that are free: no two in one. What shares a cell goes on to. */
function newPlaces(taken: readonly Cell[], free: readonly Cell[]): Map<string, Cell> | string {
  const places = new Map<string, Cell>();
  for (const cell of taken) if (hasCell(free, cell)) places.set(keyOf(cell), cell);
  const distinct = new Map(taken.map((cell) => [keyOf(cell), cell]));
  const pushed = [...distinct].flatMap(([key, cell]) => (places.has(key) ? [] : [cell]));
  const needed = places.size + pushed.length;
  if (needed > free.length) {
    const room = free.length === 1 ? "is 1 free cell" : `are ${free.length} free cells`;
    return `Too small: there ${room} for the goals’ ${needed} places. Remove goals or walls first.`;
  }
  const used = new Set(places.keys());
  for (const cell of pushed) {
    const place = nearest(
      free.filter((other) => !used.has(keyOf(other))),
      cell,
    );
    used.add(keyOf(place));
    places.set(keyOf(cell), place);
  }
  return places;
}

/** The first in reading order of those that are equally near. */
function nearest(free: readonly Cell[], cell: Cell): Cell {
  return free.reduce((best, other) => (distance(other, cell) < distance(best, cell) ? other : best));
}
