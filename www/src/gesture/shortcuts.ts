// Keys that edit wherever on the page the keyboard is: undo and redo, and giving up what is being dragged.
import { inText } from "../view/typing.js";
import { type DragStores, takeBack } from "./dragging.js";

export type ShortcutStores = DragStores;

export function shortcut(playground: ShortcutStores, event: KeyboardEvent): void {
  if (playground.editing.drag.value !== null && event.key === "Escape") {
    event.preventDefault();
    takeBack(playground);
    playground.editing.said.value = "put back.";
    return;
  }
  const action = inText(event) ? null : wanted(event);
  if (action === null) return;
  event.preventDefault();
  // Taking back what is not finished is all that is meant.
  if (playground.editing.drag.value !== null) takeBack(playground);
  else if (action === "undo") playground.edits.undo();
  else playground.edits.redo();
}

function wanted({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): "undo" | "redo" | null {
  if (!(ctrlKey || metaKey) || altKey) return null;
  if (key.toLowerCase() === "z") return shiftKey ? "redo" : "undo";
  return key.toLowerCase() === "y" && ctrlKey && !shiftKey ? "redo" : null;
}
