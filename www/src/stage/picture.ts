// The picture of a step, by what kind of problem it is.
import { html, type TemplateResult } from "lit";
import type { BoardInput, BoardName } from "./board-input.js";
import { board } from "./grid/board.js";
import { isGrid } from "./grid/cells.js";
import { loadViews, viewOf, viewsFailed } from "./lazy-views.js";
import type { BoardStores } from "./view.js";

/** A larger grid is only words: nobody could see its cells, and drawing them would hold up the page. */
const MOST_CELLS = 4096;

export function picture(name: BoardName, input: BoardInput, playground: BoardStores): TemplateResult {
  const { scene } = input;
  if (isGrid(scene) && scene.width * scene.height <= MOST_CELLS) return board(name, { ...input, scene }, playground);
  const view = viewOf(scene);
  if (view !== null) return view.board(name, input, playground);
  return viewsFailed()
    ? html`<p class="waiting">The picture could not be loaded.
        <button type="button" @click=${loadViews}>Try again</button></p>`
    : html`<p class="waiting">Loading the picture…</p>`;
}
