// The words over a board: the move, or what the observer was told and what it makes of it.
import { html, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import type { BoardName } from "./board.js";
import { isGrid } from "./grid.js";

export function boardCaption(name: BoardName, playground: Playground): TemplateResult | "" {
  const scene = playground.scene.value;
  const shown = playground.shown.value;
  if (scene === null || shown === null) return "";
  if (name === "actor") {
    const move = shown.action === null ? html`Stands at the start` : html`Moved <b>${shown.action}</b>`;
    return html`${move}<br />${playground.step.value} of ${playground.lastStep.value} moves made`;
  }
  const symbol = shown.symbols[name];
  const told = symbol === null ? html`Told nothing yet` : html`Told <b>${symbol}</b>`;
  const noun = isGrid(scene) ? "place" : "state";
  const count = shown.beliefs[name].length;
  const goals = `${shown.goals[name].length} of ${scene.goals.length} goals among them`;
  return html`${told}<br />${count} ${noun}${count === 1 ? "" : "s"}, ${goals}`;
}
