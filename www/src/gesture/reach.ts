// From a point on the screen to a cell of a board, and to the piece that a hand which aims there means.

import { inside, sameCell } from "../problem/cells.js";
import type { Piece } from "../problem/drag.js";
import { wallsOf } from "../problem/grid-cells.js";
import { things } from "../problem/pose-cells.js";
import type { Cell, FloorDocument } from "../problem/types.js";
import { goalNear, RING } from "../view/goal-place.js";
import type { BoardName } from "../view/observers.js";
import { enlarged } from "../view/scale.js";
import { pieceAt } from "./tools.js";

/** Half of the smallest target that can be hit with ease, in pixels: cells may be smaller. */
const REACH = 12;
/** A finger covers more. */
const TOUCH_REACH = 18;

/** So much of a cell's middle belongs to its goals; what is farther out, to the start's ring. */
const RING_WIDTH = 0.08;

interface Point {
  /** In cells, with fractions. */
  column: number;
  row: number;
  /** How many pixels a cell is wide. */
  scale: number;
}

/** Null while the board is not drawn. */
export function pointIn(
  board: SVGSVGElement,
  { clientX, clientY }: { clientX: number; clientY: number },
): Point | null {
  const matrix = board.getScreenCTM();
  if (matrix === null || matrix.a === 0) return null;
  return { column: (clientX - matrix.e) / matrix.a, row: (clientY - matrix.f) / matrix.d, scale: matrix.a };
}

export const cellAt = ({ column, row }: Point): Cell => [Math.floor(column), Math.floor(row)];

export interface Grasp {
  piece: Piece;
  cell: Cell;
}

/** The start and the goals are looked for first, as far as the reach goes; walls are many and near each other. */
export function grasped(document: FloorDocument, board: BoardName, point: Point, touch: boolean): Grasp | null {
  const reach = (touch ? TOUCH_REACH : REACH) / point.scale;
  const cell = cellAt(point);
  const here = inside(document, cell) ? pieceUnder(document, board, cell, point) : null;
  if (here !== null && here.kind !== "wall") return { piece: here, cell };
  const marked = nearest([...standing(document), ...document.goals.map((goal) => goal.cell)], point, reach);
  if (marked !== null) return grasp(document, board, marked);
  if (here !== null) return { piece: here, cell };
  if (board !== "actor") return null;
  const wall = nearest(wallsOf(document), point, REACH / point.scale);
  return wall === null ? null : grasp(document, board, wall);
}

/** Of what shares a cell, the goal whose mark is nearest; the start is the ring around them. */
function pieceUnder(document: FloorDocument, board: BoardName, cell: Cell, { column, row }: Point): Piece | null {
  const scale = enlarged(document);
  const cells = document.goals.map((goal) => goal.cell);
  const index = goalNear(cells, cell, { x: column, y: row }, scale);
  if (index < 0) return pieceAt(document, board, cell);
  const onRing = Math.hypot(column - cell[0] - 0.5, row - cell[1] - 0.5) > RING - RING_WIDTH;
  if (onRing && document.format === "gridworld" && sameCell(document.start, cell)) return { kind: "start" };
  return { kind: "goal", index };
}

const standing = (document: FloorDocument): Cell[] =>
  document.format === "gridworld" ? [document.start] : things(document).map(([, cell]) => cell);

function grasp(document: FloorDocument, board: BoardName, cell: Cell): Grasp | null {
  const piece = pieceAt(document, board, cell);
  return piece === null ? null : { piece, cell };
}

/** The cell whose middle is nearest, if that is within reach. */
function nearest(cells: readonly Cell[], { column, row }: Point, reach: number): Cell | null {
  let best: Cell | null = null;
  let least = reach;
  for (const cell of cells) {
    const away = Math.hypot(cell[0] + 0.5 - column, cell[1] + 0.5 - row);
    if (away <= least) {
      best = cell;
      least = away;
    }
  }
  return best;
}
