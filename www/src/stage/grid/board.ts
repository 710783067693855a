// One board: the same cells, walls and goals for everyone, and on top what this board is about. It can be edited by hand
// and by keyboard (gesture/).

import { html, nothing, svg, type TemplateResult } from "lit";
import type { State } from "../../core.js";
import { boardMarks } from "../../gesture/board-marks.js";
import { boardBlur, boardFocus, boardKey } from "../../gesture/keys.js";
import { boardPointer } from "../../gesture/pointer.js";
import { toolInHand } from "../../gesture/tools.js";
import type { Size } from "../../problem/cells.js";
import { called } from "../../view/observers.js";
import { enlarged, isLarge } from "../../view/scale.js";
import type { BoardName } from "../board-input.js";
import { goalViews } from "../goal-attributes.js";
import type { BoardStores } from "../view.js";
import { reasonMarks } from "../why.js";
import { agent, path, start } from "./agent.js";
import { cellLayer } from "./cell-layer.js";
import { type Cell, cellOf, type GridInput, keysOf } from "./cells.js";
import { goalMarks } from "./goal.js";
import { cameraCorners, camerasOn, dots, floorSquares, squares } from "./marks.js";

/** Room for strokes at the edge, in cells. */
const MARGIN = 0.06;

export function board(name: BoardName, input: GridInput, playground: BoardStores): TemplateResult {
  const { scene, shown } = input;
  const { width, height, walls } = scene;
  const box = `${-MARGIN} ${-MARGIN} ${width + 2 * MARGIN} ${height + 2 * MARGIN}`;
  const belief = name === "actor" ? [] : shown.beliefs[name];
  const scale = enlarged(scene);
  const pointer = boardPointer(name, playground);
  return html`<svg class=${boardClasses(scene, playground)} data-board=${name} viewBox=${box}
    role="application" tabindex="0" aria-label=${described(name, input)} aria-roledescription="board"
    @pointerdown=${pointer.down} @pointermove=${pointer.move} @pointerup=${pointer.up} @pointercancel=${pointer.lost}
    @lostpointercapture=${pointer.lost} @touchstart=${pointer.touch}
    @keydown=${boardKey(name, playground)} @focus=${boardFocus(name, playground)} @blur=${boardBlur(playground)}>
    ${isLarge(scene) ? ground(walls, belief, scene) : nothing}
    <g ${cellLayer({ width, height, walls, believed: keysOf(belief) })}></g>
    <path class="camera" d=${cameraCorners(camerasOn(name, playground), walls)}></path>
    <path class="dot" d=${dots(belief)}></path>
    ${name === "actor" ? nothing : reasonMarks(name, playground)}
    ${start(scene.start, scene.goals, scale)}
    ${name === "actor" ? path(input.trace, input.step) : nothing}
    ${agent(name, scene, shown.state, playground.boards.mode.value === "guess", scale)}
    ${goalMarks(
      name,
      goalViews(scene, shown),
      scene.goals.map(({ cell }) => cell),
      scale,
    )}
    ${boardMarks(name, playground)}
  </svg>`;
}

/** By the tool in the hand the board says what it can be used for. */
export function boardClasses(scene: Size, playground: BoardStores): string {
  const { editing } = playground;
  return `board ${toolInHand(playground)}${isLarge(scene) ? " large" : ""}${editing.drag.value === null ? "" : " dragging"}`;
}

/** What the cells of a large board look like; of a small one, each looks as it does by itself. */
const ground = (walls: readonly Cell[], belief: readonly State[], size: Size) =>
  svg`<path class="floor" d=${floorSquares(size)}></path><path class="believed" d=${squares(belief.map(cellOf))}></path><path class="wall" d=${squares(walls)}></path>`;

function described(name: BoardName, { scene, step, shown }: GridInput): string {
  if (name === "actor") return `The agent on a grid of ${scene.width} by ${scene.height} cells after ${step} moves.`;
  const count = shown.beliefs[name].length;
  return `After ${step} moves the ${called[name]} thinks the agent may be in ${count} of the cells.`;
}
