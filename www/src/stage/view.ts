// How the problems of one kind are shown.

import type { TemplateResult } from "lit";
import type { KeyStores } from "../gesture/keys.js";
import type { PointerStores } from "../gesture/pointer.js";
import type { BoardInput, BoardName } from "./board-input.js";
import type { WhyStores } from "./why.js";

/** What boards are drawn and edited with. */
export type BoardStores = KeyStores & PointerStores & WhyStores;

export interface View {
  board(name: BoardName, input: BoardInput, playground: BoardStores): TemplateResult;
  /** What a candidate goal asks for, where its name and its place on the boards do not say it. */
  goal?(index: number): TemplateResult | string;
  /** What the signs on the boards mean. */
  legend?(): TemplateResult;
}
