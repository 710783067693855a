// Whether the pointer is held down anywhere: then something may be dragged, and what is slow or loud can wait.
import { type ReadonlySignal, signal } from "@preact/signals-core";

const down = signal(false);
export const pressed: ReadonlySignal<boolean> = down;

for (const [type, value] of [
  ["pointerdown", true],
  ["pointerup", false],
  ["pointercancel", false],
  // A file dragged into the page ends no press.
  ["dragend", false],
  ["blur", false],
] as const) {
  window.addEventListener(
    type,
    () => {
      down.value = value;
    },
    { capture: true, passive: true },
  );
}
