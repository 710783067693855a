// Edits of a grid's cells: where things stand, walls, first beliefs and cameras. What can't be done leaves the document
// as it is, so that whatever is dragged or painted, the core takes what comes out.
import { everyCell, hasCell, inside, sameCell, without } from "./cells.js";
import { poseTaken, setPoseWall } from "./pose-cells.js";
import type { Cell, FloorDocument, GridObserver, GridworldDocument, Role } from "./types.js";

const roles: readonly Role[] = ["adversarial", "cooperative"];

export const wallsOf = (document: FloorDocument): readonly Cell[] => document.walls ?? [];

export const isWall = (document: FloorDocument, cell: Cell): boolean => hasCell(wallsOf(document), cell);

export const isFree = (document: FloorDocument, cell: Cell): boolean =>
  inside(document, cell) && !isWall(document, cell);

/** The start or a goal stands there: it can't become a wall. */
export const isTaken = (document: FloorDocument, cell: Cell): boolean =>
  document.format === "gridworld"
    ? sameCell(document.start, cell) || document.goals.some((goal) => sameCell(goal.cell, cell))
    : poseTaken(document, cell);

export const freeCells = (document: FloorDocument): Cell[] => {
  const walls = new Set(wallsOf(document).map(String));
  return everyCell(document).filter((cell) => !walls.has(String(cell)));
};

export const beliefOf = (document: GridworldDocument, role: Role): readonly Cell[] =>
  document.observers[role].initial_belief ?? [document.start];

export const camerasOf = (document: GridworldDocument, role: Role): readonly Cell[] =>
  document.observers[role].cameras ?? [];

export function withObserver(
  document: GridworldDocument,
  role: Role,
  change: (observer: GridObserver) => GridObserver,
): GridworldDocument {
  return { ...document, observers: { ...document.observers, [role]: change(document.observers[role]) } };
}

/** A first belief is written down where it is more than the start. */
export function withBelief(document: GridworldDocument, role: Role, cells: readonly Cell[]): GridworldDocument {
  return withObserver(document, role, ({ initial_belief: _before, ...rest }) =>
    cells.every((cell) => sameCell(cell, document.start)) ? rest : { initial_belief: [...cells], ...rest },
  );
}

export function withCameras(document: GridworldDocument, role: Role, cells: readonly Cell[]): GridworldDocument {
  return withObserver(document, role, ({ cameras: _before, ...rest }) =>
    cells.length === 0 ? rest : { cameras: [...cells], ...rest },
  );
}

/** Who took the agent to be at the start goes on to do so. Who held the new place possible already, keeps to that. */
export function moveStart(document: GridworldDocument, cell: Cell): GridworldDocument {
  if (!isFree(document, cell)) return document;
  let moved: GridworldDocument = { ...document, start: cell };
  for (const role of roles) {
    const belief = beliefOf(document, role);
    const followed = hasCell(belief, cell)
      ? belief
      : belief.map((believed) => (sameCell(believed, document.start) ? cell : believed));
    moved = withBelief(moved, role, followed);
  }
  return moved;
}

export function moveGoal<D extends FloorDocument>(document: D, index: number, cell: Cell): D {
  if (!isFree(document, cell)) return document;
  return { ...document, goals: document.goals.map((goal, at) => (at === index ? { ...goal, cell } : goal)) };
}

export function setWall<D extends FloorDocument>(document: D, cell: Cell, wall: boolean): D;
export function setWall(document: FloorDocument, cell: Cell, wall: boolean): FloorDocument {
  if (document.format !== "gridworld") return setPoseWall(document, cell, wall);
  if (!inside(document, cell) || isWall(document, cell) === wall) return document;
  if (!wall) return { ...document, walls: without(wallsOf(document), cell) };
  if (isTaken(document, cell)) return document;
  let walled: GridworldDocument = { ...document, walls: [...wallsOf(document), cell] };
  for (const role of roles) {
    const belief = beliefOf(document, role);
    if (hasCell(belief, cell)) walled = withBelief(walled, role, without(belief, cell));
  }
  return walled;
}

export function moveWall<D extends FloorDocument>(document: D, from: Cell, to: Cell): D {
  if (!isFree(document, to) || isTaken(document, to)) return document;
  return setWall(setWall(document, from, false), to, true);
}

/** The start always stays in: the agent is there. */
export function setBelieved(document: GridworldDocument, role: Role, cell: Cell, believed: boolean): GridworldDocument {
  const belief = beliefOf(document, role);
  if (hasCell(belief, cell) === believed || !isFree(document, cell)) return document;
  if (!believed && sameCell(cell, document.start)) return document;
  return withBelief(document, role, believed ? [...belief, cell] : without(belief, cell));
}

export function setCamera(document: GridworldDocument, role: Role, cell: Cell, camera: boolean): GridworldDocument {
  const cameras = camerasOf(document, role);
  if (hasCell(cameras, cell) === camera || !isFree(document, cell)) return document;
  return withCameras(document, role, camera ? [...cameras, cell] : without(cameras, cell));
}

export const believeEverywhere = (document: GridworldDocument, role: Role): GridworldDocument =>
  withBelief(document, role, freeCells(document));

export const believeStart = (document: GridworldDocument, role: Role): GridworldDocument =>
  withBelief(document, role, [document.start]);

/** In the walls too: one that is taken away later is no hole in the view. */
export const watchEverywhere = (document: GridworldDocument, role: Role): GridworldDocument =>
  withCameras(document, role, everyCell(document));

export const watchNowhere = (document: GridworldDocument, role: Role): GridworldDocument =>
  withCameras(document, role, []);
