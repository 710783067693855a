// What the person's hands are doing: the tool in them, what is being dragged, where the keyboard's cursor is. Nothing of
// this is part of the problem; the playground hears of an edit when it is made.
import { signal } from "@preact/signals-core";
import type { Drag } from "../problem/drag.js";
import type { Cell, Role } from "../problem/types.js";

export type Tool = "move" | "walls" | "belief" | "cameras";

export interface Cursor {
  board: "actor" | Role;
  cell: Cell;
  /** Where the mouse was pressed the cursor waits unseen until a key calls for it. */
  shown: boolean;
}

/** A field whose text can't be taken, while the document is the one it was typed for. */
export interface Fault {
  field: string;
  text: string;
  message: string;
  document: unknown;
}

export class Editing {
  readonly tool = signal<Tool>("move");
  readonly drag = signal<Drag | null>(null);
  /** The keyboard's place on a board that has its focus. */
  readonly cursor = signal<Cursor | null>(null);
  /** What there is to say to somebody who does not see the boards. */
  readonly said = signal("");
  readonly fault = signal<Fault | null>(null);
  /** What an edit took along, in words. */
  readonly note = signal<{ text: string; document: unknown } | null>(null);
}
