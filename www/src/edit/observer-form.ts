// What an observer of a grid is told and believes at first: symbols, cameras, first belief.
import { html, type TemplateResult } from "lit";
import { take } from "../gesture/tools.js";
import {
  beliefOf,
  believeEverywhere,
  believeStart,
  camerasOf,
  isFree,
  watchEverywhere,
  watchNowhere,
} from "../problem/grid-cells.js";
import { type GridPreset, gridPresets, movesOf, presetOf, setSymbol, usePreset } from "../problem/grid-sensor.js";
import type { GridworldDocument, Role } from "../problem/types.js";
import type { Tool } from "../state/editing.js";
import type { Timeline } from "../state/timeline.js";
import { called } from "../view/observers.js";
import { playgroundAround } from "../view/surroundings.js";
import { attempt, type Edited, type FieldStores, lockNote, presetField, textField } from "./fields.js";

export interface ObserverFormStores extends FieldStores {
  timeline: Timeline;
}

const titles = Object.fromEntries(Object.entries(gridPresets).map(([name, { title }]) => [name, title])) as Record<
  GridPreset,
  string
>;

export function observerForm(playground: ObserverFormStores, document: GridworldDocument, role: Role): TemplateResult {
  const { sensor } = document.observers[role];
  const cells = (count: number) => (count === 1 ? "1 cell" : `${count} cells`);
  const watched = camerasOf(document, role).filter((cell) => isFree(document, cell)).length;
  const edit = (edited: Edited) => attempt(playground, `${role}-cells`, edited);
  const paint = (tool: Tool) => (event: Event) => {
    take(playground, tool);
    // The boards are above: the hand needs to see them.
    const around = playgroundAround(event.currentTarget as Element);
    around?.querySelector(`[data-board=${role}]`)?.scrollIntoView({ block: "nearest" });
  };
  const { locked, note } = lockNote(playground, ["observers"]);
  return html`<fieldset class="observer ${role}" ?disabled=${locked}>
    <legend>What the ${called[role]} is told</legend>
    ${note}
    ${presetField("Sensor", titles, presetOf(document, role), (name) => edit(usePreset(document, role, name)))}
    <div class="row moves" role="group" aria-label="Symbol for each move, for the ${called[role]}">
      ${movesOf(document).map((move) =>
        textField(playground, {
          field: `${role}-${move}`,
          label: move === "stay" ? "Staying" : `Moving ${move}`,
          value: sensor[move] ?? "",
          list: `${playground.workbench.id}-symbols`,
          save: (text) => setSymbol(document, role, move, text),
        }),
      )}
    </div>
    <small>Moves with the same symbol look the same to the ${called[role]}.</small>
    <div class="choice" role="group" aria-label="Cameras of the ${called[role]}">
      <span><b>Cameras</b> in ${watched === 0 ? "no cell" : cells(watched)}</span>
      <button type="button" @click=${() => edit(watchNowhere(document, role))}>None</button>
      <button type="button" @click=${() => edit(watchEverywhere(document, role))}>Everywhere</button>
      <button type="button" @click=${paint("cameras")}>Paint</button>
      <small>Where a camera is, the ${called[role]} sees the agent exactly.</small>
    </div>
    <div class="choice" role="group" aria-label="First belief of the ${called[role]}">
      <span><b>First belief</b>: ${cells(beliefOf(document, role).length)}</span>
      <button type="button" @click=${() => edit(believeStart(document, role))}>Start alone</button>
      <button type="button" @click=${() => edit(believeEverywhere(document, role))}>Everywhere</button>
      <button type="button" @click=${paint("belief")}>Paint</button>
      <small>Where the ${called[role]} thinks the agent may begin; the start is always among these cells.</small>
    </div>
  </fieldset>`;
}
