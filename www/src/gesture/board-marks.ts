// What editing draws on a board: the keyboard's cursor, and where that which is dragged is now.
import { nothing, svg } from "lit";
import type { Editing } from "../state/editing.js";
import type { BoardName } from "../view/observers.js";

interface BoardMarkStores {
  editing: Editing;
}

export function boardMarks(board: BoardName, { editing }: BoardMarkStores) {
  const cursor = editing.cursor.value;
  const drag = editing.drag.value;
  const frame = ([column, row]: readonly [number, number], look: string) =>
    svg`<rect class=${look} x=${column + 0.03} y=${row + 0.03} width="0.94" height="0.94" rx="0.13"></rect>`;
  const carried = drag?.kind === "carry" ? frame(drag.at, drag.taken ? "carried" : "carried refused") : nothing;
  return svg`${carried}${cursor?.shown === true && cursor.board === board ? frame(cursor.cell, "cursor") : nothing}`;
}
