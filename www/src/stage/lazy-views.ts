// The pictures of the domains that not everybody looks at: their code is fetched with the first problem that needs it.
import { signal } from "@preact/signals-core";
import type { Scene } from "../core.js";
import type { View } from "./view.js";
import { loadViewStyles } from "./view-styles.js";

type Views = (scene: Scene) => View;

const loaded = signal<Views | null>(null);
const failed = signal(false);
let asked = false;

export const viewsFailed = (): boolean => failed.value;

export function loadViews(): void {
  if (asked) return;
  asked = true;
  failed.value = false;
  Promise.all([import("./views.js"), loadViewStyles()]).then(
    ([{ viewOf }]) => {
      loaded.value = viewOf;
    },
    () => {
      asked = false;
      failed.value = true;
    },
  );
}

/** Null while the code is on its way; whoever asks is drawn again when it is there. */
export function viewOf(scene: Scene): View | null {
  const views = loaded.value;
  if (views === null && !failed.value) loadViews();
  return views?.(scene) ?? null;
}
