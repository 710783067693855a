// The pictures of the domains that not everybody looks at: their code is fetched with the first problem that needs it.
import { signal } from "@preact/signals-core";
import type { TemplateResult } from "lit";
import type { Scene } from "../core.js";
import type { KeyStores } from "../gesture/keys.js";
import type { PointerStores } from "../gesture/pointer.js";
import type { BoardInput, BoardName } from "./board-input.js";

/** What boards are drawn and edited with. */
export type BoardStores = KeyStores & PointerStores;

/** How the problems of one kind are shown. */
export interface View {
  board(name: BoardName, input: BoardInput, playground: BoardStores): TemplateResult;
  /** What a candidate goal asks for, where its name and its place on the boards do not say it. */
  goal?(index: number): TemplateResult | string;
  /** What the signs on the boards mean. */
  legend?(): TemplateResult;
}

type Views = (scene: Scene) => View;

const loaded = signal<Views | null>(null);
const failed = signal(false);
let asked = false;

export const viewsFailed = (): boolean => failed.value;

export function loadViews(): void {
  if (asked) return;
  asked = true;
  failed.value = false;
  import("./views.js").then(
    ({ viewOf }) => {
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
