// One board: the same cells, walls and goals for everyone, and on top what this board is about.
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Playground } from "../../state/playground.js";
import { called } from "../../view/observers.js";
import type { BoardName } from "../board-input.js";
import { goalViews } from "../goal-attributes.js";
import { agent, path, start } from "./agent.js";
import { type CellView, cellViews } from "./cell-views.js";
import type { GridInput } from "./cells.js";
import { goalMark } from "./goal.js";

/** Room for strokes at the edge, in cells. */
const MARGIN = 0.06;

export function board(name: BoardName, input: GridInput, playground: Playground): TemplateResult {
  const { scene, shown } = input;
  const { width, height } = scene;
  const box = `${-MARGIN} ${-MARGIN} ${width + 2 * MARGIN} ${height + 2 * MARGIN}`;
  return html`<svg class="board" data-board=${name} viewBox=${box} role="img" aria-label=${described(name, input)}>
    ${cellViews(name, input, playground).map(cell)} ${start(scene.start)}
    ${name === "actor" ? path(input.trace, input.step) : nothing}
    ${agent(name, scene, shown.state, playground.mode.value === "guess")}
    ${goalViews(scene, shown).map((goal, index) => goalMark(name, goal, scene.goals[index]?.cell ?? scene.start))}
  </svg>`;
}

/** A believed cell is shaded and carries a dot, so that it does not take colour to see it. */
function cell({ key, column, row, wall, believed, camera }: CellView) {
  return svg`<rect class=${wall ? "wall" : "floor"} data-cell=${key} ?data-believed=${believed}
      x=${column + 0.03} y=${row + 0.03} width="0.94" height="0.94" rx="0.13"></rect>
    ${camera ? svg`<path class="camera" d=${`M${column + 0.1} ${row + 0.3}v-0.2h0.2M${column + 0.7} ${row + 0.1}h0.2v0.2M${column + 0.9} ${row + 0.7}v0.2h-0.2M${column + 0.3} ${row + 0.9}h-0.2v-0.2`}></path>` : nothing}
    ${believed ? svg`<circle class="dot" cx=${column + 0.5} cy=${row + 0.5} r="0.1"></circle>` : nothing}`;
}

function described(name: BoardName, { scene, step, shown }: GridInput): string {
  if (name === "actor") return `The agent on a grid of ${scene.width} by ${scene.height} cells after ${step} moves.`;
  const count = shown.beliefs[name].length;
  return `After ${step} moves the ${called[name]} thinks the agent may be in ${count} of the cells.`;
}
