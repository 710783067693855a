// A drag and the playground: it is shown with its best plan while it goes on, made when it ends, or taken back.
import { sameCell } from "../problem/cells.js";
import { type Drag, draggedTo } from "../problem/drag.js";
import type { Cell } from "../problem/types.js";
import type { Editing } from "../state/editing.js";
import type { Edits } from "../state/edits.js";

export interface DragStores {
  editing: Editing;
  edits: Edits;
}

export function begin(playground: DragStores, drag: Drag): void {
  playground.editing.drag.value = drag;
  if (drag.document !== drag.base) playground.edits.preview(drag.document);
}

export function goTo(playground: DragStores, cell: Cell): void {
  const { drag } = playground.editing;
  const before = drag.value;
  if (before === null || sameCell(before.at, cell)) return;
  const after = draggedTo(before, cell);
  drag.value = after;
  if (after.document !== before.document) playground.edits.preview(after.document);
}

export function finish(playground: DragStores): void {
  playground.editing.drag.value = null;
  playground.edits.commit();
}

/** Everything is as it was before the drag. */
export function takeBack(playground: DragStores): void {
  if (playground.editing.drag.value === null) return;
  playground.editing.drag.value = null;
  playground.edits.takeBack();
}
