// The agent on a board: where it started, its way, and where it is. The observers' boards show it as a mere outline,
// for the reader: the observers do not see it.
import { nothing, svg } from "lit";
import type { State, Trace } from "../../core.js";
import { sameCell } from "../../problem/cells.js";
import { RING } from "../../view/goal-place.js";
import type { BoardName } from "../board-input.js";
import { type Cell, cellOf, type GridScene, keyOf } from "./cells.js";

/** Where goals stand as well, the start is a ring around them. */
export function start(cell: Cell, goals: readonly { cell: Cell }[], scale: number) {
  const shared = goals.some((goal) => sameCell(goal.cell, cell));
  return svg`<circle class="start" cx=${cell[0] + 0.5} cy=${cell[1] + 0.5} r=${(shared ? RING : 0.2) * scale}></circle>`;
}

/** The steps walked as a line, the ones to come as dots. */
export function path(trace: Trace, step: number) {
  const points = trace.steps.map(({ state }) => {
    const [column, row] = cellOf(state);
    return `${column + 0.5},${row + 0.5}`;
  });
  return svg`<polyline class="ahead" points=${points.slice(step).join(" ")}></polyline>
    <polyline class="walked" points=${points.slice(0, step + 1).join(" ")}></polyline>`;
}

/** `secret`: the reader is the enemy, and does not see it either. */
export function agent(board: BoardName, scene: GridScene, state: State, secret: boolean, scale: number) {
  if (secret) return nothing;
  const [column, row] = cellOf(state);
  const onGoal = scene.goals.some(({ cell }) => keyOf(cell) === keyOf([column, row]));
  // On a goal's cell it becomes a ring, so that the goal stays readable.
  const look = board === "actor" ? (onGoal ? "here ring" : "here") : "hidden-here ring";
  const radius = onGoal ? 0.44 : board === "actor" ? 0.26 : 0.34;
  return svg`<circle class=${look} cx=${column + 0.5} cy=${row + 0.5} r=${radius * scale}></circle>`;
}
