// A candidate goal on a board: a badge with its name. On an observer's board it is filled while the goal is possible
// for that observer, hollow while it is not, and struck through when it is ruled out. On the agent's board it has a mark for each: a
// diamond for the enemy, a disc for the friend, filled while the goal is possible for them. The true goal has a star.

import { nothing, svg } from "lit";
import { visible } from "../../problem/unseen.js";
import { type Place, placesOf } from "../../view/goal-place.js";
import { starPath } from "../../view/icons.js";
import type { BoardName } from "../board-input.js";
import type { GoalView } from "../goal-attributes.js";
import { goalTold, looks, marks } from "../goal-marks.js";
import type { Cell } from "./cells.js";
import { goalLayer, MANY_GOALS } from "./goal-layer.js";

const LONGEST_LABEL = 3;

/** The marks of all goals: those that share a cell stand side by side in it, and the true goal is on top of all. */
export function goalMarks(board: BoardName, goals: readonly GoalView[], cells: readonly Cell[], scale: number) {
  // Larger than their cells they would hide each other.
  const many = goals.length > MANY_GOALS;
  const places = placesOf(cells, many ? 1 : scale);
  if (many) return svg`<g ${goalLayer({ board, goals, places })}></g>`;
  const placed = goals.map((goal, index) => ({ goal, place: places[index] ?? { x: 0, y: 0, scale } }));
  return [...placed.filter(({ goal }) => !goal.isTrue), ...placed.filter(({ goal }) => goal.isTrue)].map(
    ({ goal, place }) => goalMark(board, goal, place),
  );
}

function goalMark(board: BoardName, goal: GoalView, { x, y, scale }: Place) {
  const look = board === "actor" ? "plain" : looks[goal.standing[board]];
  const label = shortened(visible(goal.name));
  return svg`<g class="goal ${look}" transform=${`translate(${x} ${y})${scale === 1 ? "" : ` scale(${scale})`}`}
      data-goal=${goal.name} data-adversarial=${goal.attributes.adversarial}
      data-cooperative=${goal.attributes.cooperative} ?data-true-goal=${goal.isTrue}>
    <title>${goalTold(goal)}</title>
    <rect class="badge" x="-0.35" y="-0.27" width="0.7" height="0.54" rx="0.16"></rect>
    ${look === "dead" ? svg`<line class="strike" x1="-0.33" y1="0.27" x2="0.33" y2="-0.27"></line>` : nothing}
    <text class="label ${label.length > 2 ? "long" : ""}" y="0.115">${label}</text>
    ${board === "actor" ? marks(goal, 0.3) : nothing}
    ${goal.isTrue ? svg`<path class="star" transform="translate(0.31 -0.29) scale(0.2)" d=${starPath}></path>` : nothing}
  </g>`;
}

/** Names are the document's and may be long; the list of goals has them in full. */
function shortened(name: string): string {
  const letters = [...name];
  return letters.length <= LONGEST_LABEL ? name : `${letters.slice(0, LONGEST_LABEL - 1).join("")}…`;
}
