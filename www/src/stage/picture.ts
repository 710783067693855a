// The picture of a step, by what kind of problem it is.
import type { TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { beliefText } from "./belief-text.js";
import type { BoardInput, BoardName } from "./board-input.js";
import { deliveryBoard } from "./delivery/board.js";
import { isDelivery } from "./delivery/facts.js";
import { board } from "./grid/board.js";
import { isGrid } from "./grid/cells.js";

/** A larger grid is only words: nobody could see its cells, and drawing them would hold up the page. */
const MOST_CELLS = 4096;

export function picture(name: BoardName, input: BoardInput, playground: Playground): TemplateResult {
  const { scene } = input;
  if (isGrid(scene) && scene.width * scene.height <= MOST_CELLS) return board(name, { ...input, scene }, playground);
  if (isDelivery(scene)) return deliveryBoard(name, { ...input, scene }, playground);
  return beliefText(name, input.shown);
}
