// The picture of a step, by what kind of problem it is.
import type { TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { beliefText } from "./belief-text.js";
import type { BoardInput, BoardName } from "./board-input.js";
import { deliveryBoard } from "./delivery/board.js";
import { isDelivery } from "./delivery/facts.js";
import { board } from "./grid/board.js";
import { isGrid } from "./grid/cells.js";

export function picture(name: BoardName, input: BoardInput, playground: Playground): TemplateResult {
  const { scene } = input;
  if (isGrid(scene)) return board(name, { ...input, scene }, playground);
  if (isDelivery(scene)) return deliveryBoard(name, { ...input, scene }, playground);
  return beliefText(name, input.shown);
}
