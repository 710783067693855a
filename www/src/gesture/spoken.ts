// What is in a cell, for those who do not see the boards.
import { cellText, hasCell, sameCell } from "../problem/cells.js";
import type { Drag } from "../problem/drag.js";
import { beliefOf, camerasOf, isWall } from "../problem/grid-cells.js";
import { things } from "../problem/pose-cells.js";
import type { Cell, FloorDocument } from "../problem/types.js";
import type { BoardName } from "../view/observers.js";

/** "column 3, row 2: wall" */
export const cellInWords = (document: FloorDocument, board: BoardName, cell: Cell): string =>
  `${cellText(cell)}: ${contents(document, board, cell).join(", ")}`;

function contents(document: FloorDocument, board: BoardName, cell: Cell): string[] {
  if (isWall(document, cell)) return ["wall"];
  const parts: string[] = [];
  if (document.format === "gridworld") {
    if (sameCell(document.start, cell)) parts.push("start");
  } else {
    parts.push(...things(document).flatMap(([thing, place]) => (sameCell(place, cell) ? [thing] : [])));
  }
  for (const goal of document.goals) {
    if (sameCell(goal.cell, cell))
      parts.push(goal.name === document.true_goal ? `true goal ${goal.name}` : `goal ${goal.name}`);
  }
  if (board !== "actor" && document.format === "gridworld") {
    if (hasCell(beliefOf(document, board), cell)) parts.push("in the first belief");
    if (hasCell(camerasOf(document, board), cell)) parts.push("camera");
  }
  return parts.length > 0 ? parts : ["free"];
}

/** How a piece that is carried is doing. */
export function carriedInWords(drag: Drag, document: FloorDocument, board: BoardName): string {
  if (drag.kind === "stroke") return cellInWords(document, board, drag.at);
  return drag.taken
    ? `${pieceName(drag)} at ${cellText(drag.at)}`
    : `${pieceName(drag)} can’t stand at ${cellText(drag.at)}`;
}

export function pieceName(drag: Drag): string {
  if (drag.kind === "stroke") return "brush";
  const { piece, base } = drag;
  if (piece.kind === "thing") return piece.thing;
  return piece.kind === "goal" ? `goal ${base.goals[piece.index]?.name ?? ""}` : piece.kind;
}
