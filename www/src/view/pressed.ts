// Whether the pointer is held down anywhere: then something may be dragged, and what is slow or loud can wait.
import { type ReadonlySignal, signal } from "@preact/signals-core";

const down = signal(false);
export const pressed: ReadonlySignal<boolean> = down;

function listen(type: string, value: boolean, from?: EventTarget): void {
  const take = ({ target }: Event) => {
    if (from === undefined || target === from) down.value = value;
  };
  window.addEventListener(type, take, { capture: true, passive: true });
}

listen("pointerdown", true);
listen("pointerup", false);
listen("pointercancel", false);
// What is dragged out of the page or dropped ends with no other event.
listen("dragend", false);
// The window itself, when it is left: fields lose the focus in the middle of a press as well.
listen("blur", false, window);
