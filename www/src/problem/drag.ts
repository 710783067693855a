// A drag, from the first cell to the last: a piece that is carried, or a stroke of a brush. It starts from one document
// and knows the document that it has made so far; what it is shown with, and by which device, is no matter of its own.
import { between, hasCell, sameCell } from "./cells.js";
import {
  beliefOf,
  camerasOf,
  isWall,
  moveGoal,
  moveStart,
  moveWall,
  setBelieved,
  setCamera,
  setWall,
} from "./grid-cells.js";
import { moveThing, type Thing } from "./pose-cells.js";
import type { Cell, FloorDocument, Role } from "./types.js";

/** What can be carried. */
export type Piece =
  | { kind: "start" }
  | { kind: "thing"; thing: Thing }
  | { kind: "goal"; index: number }
  | { kind: "wall" };

/** What can be painted. */
export type Paint = { kind: "wall" } | { kind: "belief"; role: Role } | { kind: "camera"; role: Role };

interface Part {
  /** Where the drag is now. */
  at: Cell;
  base: FloorDocument;
  /** What has come of it so far. */
  document: FloorDocument;
}

export interface Carry extends Part {
  kind: "carry";
  piece: Piece;
  from: Cell;
  /** Whether the piece may stand where the drag is now. */
  taken: boolean;
}

export interface Stroke extends Part {
  kind: "stroke";
  paint: Paint;
  /** Painting, or taking away. */
  on: boolean;
}

export type Drag = Carry | Stroke;

export function carry(document: FloorDocument, piece: Piece, from: Cell): Carry {
  return { kind: "carry", piece, from, at: from, base: document, document, taken: true };
}

/** The first cell decides whether the stroke paints or takes away. */
export function stroke(document: FloorDocument, paint: Paint, from: Cell): Stroke {
  const on = !isPainted(document, paint, from);
  return { kind: "stroke", paint, on, at: from, base: document, document: painted(document, paint, from, on) };
}

/** The drag goes on to another cell. */
export function draggedTo(drag: Drag, cell: Cell): Drag {
  return drag.kind === "carry" ? carriedTo(drag, cell) : strokedTo(drag, cell);
}

/** A piece that can't stand there waits where it could last. */
function carriedTo(drag: Carry, cell: Cell): Carry {
  if (sameCell(cell, drag.from)) return { ...drag, at: cell, document: drag.base, taken: true };
  const moved = placed(drag.base, drag.piece, drag.from, cell);
  const taken = moved !== drag.base;
  return { ...drag, at: cell, taken, document: taken ? moved : drag.document };
}

function strokedTo(drag: Stroke, cell: Cell): Stroke {
  const paint = (document: FloorDocument, next: Cell) => painted(document, drag.paint, next, drag.on);
  return { ...drag, at: cell, document: between(drag.at, cell).reduce(paint, drag.document) };
}

function placed(document: FloorDocument, piece: Piece, from: Cell, to: Cell): FloorDocument {
  switch (piece.kind) {
    case "start":
      return document.format === "gridworld" ? moveStart(document, to) : document;
    case "thing":
      return document.format === "gridworld" ? document : moveThing(document, piece.thing, to);
    case "goal":
      return moveGoal(document, piece.index, to);
    case "wall":
      return moveWall(document, from, to);
  }
}

export function isPainted(document: FloorDocument, paint: Paint, cell: Cell): boolean {
  if (paint.kind === "wall") return isWall(document, cell);
  if (document.format !== "gridworld") return false;
  switch (paint.kind) {
    case "belief":
      // The start can't be taken away, so a stroke that begins there paints.
      return !sameCell(cell, document.start) && hasCell(beliefOf(document, paint.role), cell);
    case "camera":
      return hasCell(camerasOf(document, paint.role), cell);
  }
}

function painted(document: FloorDocument, paint: Paint, cell: Cell, on: boolean): FloorDocument {
  if (paint.kind === "wall") return setWall(document, cell, on);
  if (document.format !== "gridworld") return document;
  switch (paint.kind) {
    case "belief":
      return setBelieved(document, paint.role, cell, on);
    case "camera":
      return setCamera(document, paint.role, cell, on);
  }
}
