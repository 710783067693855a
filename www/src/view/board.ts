// One board: the same cells, walls and goals for everyone, and on top what this board is about.
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Trace, TraceStep } from "../core.js";
import { agent, path, start } from "./board-agent.js";
import { goalMark } from "./board-goal.js";
import { goalViews } from "./goal-attributes.js";
import { type GridScene, keyOf, keysOf } from "./grid.js";
import { called, type Role } from "./observers.js";

export type BoardName = "actor" | Role;

export interface BoardInput {
  scene: GridScene;
  trace: Trace;
  step: number;
  shown: TraceStep;
}

/** Room for strokes at the edge, in cells. */
const MARGIN = 0.06;

export function board(name: BoardName, input: BoardInput): TemplateResult {
  const { scene, shown } = input;
  const { width, height } = scene;
  const box = `${-MARGIN} ${-MARGIN} ${width + 2 * MARGIN} ${height + 2 * MARGIN}`;
  return html`<svg class="board" data-board=${name} viewBox=${box} role="img" aria-label=${described(name, input)}>
    ${cells(name, scene, shown)} ${start(scene.start)}
    ${name === "actor" ? path(input.trace, input.step) : nothing}
    ${agent(name, scene, shown.state)}
    ${goalViews(scene, shown).map((goal, index) => goalMark(name, goal, scene.goals[index]?.cell ?? scene.start))}
  </svg>`;
}

function cells(name: BoardName, scene: GridScene, shown: TraceStep) {
  const walls = new Set(scene.walls.map(keyOf));
  const believed = name === "actor" ? new Set<string>() : keysOf(shown.beliefs[name]);
  const drawn = [];
  for (let row = 0; row < scene.height; row += 1) {
    for (let column = 0; column < scene.width; column += 1) {
      const key = keyOf([column, row]);
      drawn.push(cell(column, row, walls.has(key), believed.has(key)));
    }
  }
  return drawn;
}

/** A believed cell is shaded and carries a dot, so that it does not take colour to see it. */
function cell(column: number, row: number, wall: boolean, believed: boolean) {
  return svg`<rect class=${wall ? "wall" : "floor"} data-cell="${column},${row}" ?data-believed=${believed}
      x=${column + 0.03} y=${row + 0.03} width="0.94" height="0.94" rx="0.13"></rect>
    ${believed ? svg`<circle class="dot" cx=${column + 0.5} cy=${row + 0.5} r="0.1"></circle>` : nothing}`;
}

function described(name: BoardName, { scene, step, shown }: BoardInput): string {
  if (name === "actor") return `The agent on a grid of ${scene.width} by ${scene.height} cells after ${step} moves.`;
  const count = shown.beliefs[name].length;
  return `After ${step} moves the ${called[name]} thinks the agent may be in ${count} of the cells.`;
}
