// What is in a cell, for those who do not see the boards.
import { hasCell, sameCell } from "../problem/cells.js";
import { beliefOf, camerasOf, isWall } from "../problem/grid-cells.js";
import type { Cell, GridworldDocument } from "../problem/types.js";
import type { BoardName } from "../stage/board-input.js";
import type { Drag } from "./drag.js";

const place = ([column, row]: Cell): string => `column ${column}, row ${row}`;

/** "column 3, row 2: wall" */
export const cellInWords = (document: GridworldDocument, board: BoardName, cell: Cell): string =>
  `${place(cell)}: ${contents(document, board, cell).join(", ")}`;

function contents(document: GridworldDocument, board: BoardName, cell: Cell): string[] {
  if (isWall(document, cell)) return ["wall"];
  const parts: string[] = [];
  if (sameCell(document.start, cell)) parts.push("start");
  for (const goal of document.goals) {
    if (sameCell(goal.cell, cell))
      parts.push(goal.name === document.true_goal ? `true goal ${goal.name}` : `goal ${goal.name}`);
  }
  if (board !== "actor") {
    if (hasCell(beliefOf(document, board), cell)) parts.push("in the first belief");
    if (hasCell(camerasOf(document, board), cell)) parts.push("camera");
  }
  return parts.length > 0 ? parts : ["free"];
}

/** How a piece that is carried is doing. */
export function carriedInWords(drag: Drag, document: GridworldDocument, board: BoardName): string {
  if (drag.kind === "stroke") return cellInWords(document, board, drag.at);
  return drag.taken ? `${pieceName(drag)} at ${place(drag.at)}` : `${pieceName(drag)} can’t stand at ${place(drag.at)}`;
}

export function pieceName(drag: Drag): string {
  if (drag.kind === "stroke") return "brush";
  const { piece, base } = drag;
  return piece.kind === "goal" ? `goal ${base.goals[piece.index]?.name ?? ""}` : piece.kind;
}
