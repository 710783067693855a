// A drag and the playground: it is shown with its best plan while it goes on, made when it ends, or taken back.
import { sameCell } from "../problem/cells.js";
import { type Drag, draggedTo } from "../problem/drag.js";
import type { Cell } from "../problem/types.js";
import type { Playground } from "../state/playground.js";

export function begin(playground: Playground, drag: Drag): void {
  playground.editing.drag.value = drag;
  if (drag.document !== drag.base) playground.preview(drag.document);
}

export function goTo(playground: Playground, cell: Cell): void {
  const { drag } = playground.editing;
  const before = drag.value;
  if (before === null || sameCell(before.at, cell)) return;
  const after = draggedTo(before, cell);
  drag.value = after;
  if (after.document !== before.document) playground.preview(after.document);
}

export function finish(playground: Playground): void {
  playground.editing.drag.value = null;
  playground.commit();
}

/** Everything is as it was before the drag. */
export function takeBack(playground: Playground): void {
  if (playground.editing.drag.value === null) return;
  playground.editing.drag.value = null;
  playground.takeBack();
}
