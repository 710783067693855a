// A candidate goal on a board: a badge with its name. Filled while the goal is still possible for this board's
// observer, hollow and struck through when it is ruled out; the true goal has a star.
import { nothing, svg } from "lit";
import type { BoardName } from "./board.js";
import type { GoalView } from "./goal-attributes.js";
import type { Cell } from "./grid.js";

const LONGEST_LABEL = 3;

export function goalMark(board: BoardName, goal: GoalView, [column, row]: Cell) {
  const look = board === "actor" ? "plain" : goal.attributes[board];
  return svg`<g class="goal ${look}" transform="translate(${column + 0.5} ${row + 0.5})"
      data-goal=${goal.name} data-adversarial=${goal.attributes.adversarial}
      data-cooperative=${goal.attributes.cooperative} ?data-true-goal=${goal.isTrue}>
    <title>${goal.name}${goal.isTrue ? " (true goal)" : ""}</title>
    <rect class="badge" x="-0.33" y="-0.27" width="0.66" height="0.54" rx="0.16"></rect>
    ${look === "dead" ? svg`<line class="strike" x1="-0.33" y1="0.27" x2="0.33" y2="-0.27"></line>` : nothing}
    <text class="label" y="0.115">${shortened(goal.name)}</text>
    ${goal.isTrue ? svg`<path class="star" transform="translate(0.3 -0.28) scale(0.2)" d=${starPath}></path>` : nothing}
  </g>`;
}

/** Names are the document's and may be long; the list of goals has them in full. */
function shortened(name: string): string {
  const letters = Array.from(name);
  return letters.length <= LONGEST_LABEL ? name : `${letters.slice(0, LONGEST_LABEL - 1).join("")}…`;
}

/** A five-pointed star around the origin, one unit to each point. */
export const starPath = `M${Array.from({ length: 10 }, (_, corner) => {
  const [angle, radius] = [(corner * Math.PI) / 5, corner % 2 === 0 ? 1 : 0.45];
  return `${(radius * Math.sin(angle)).toFixed(3)} ${(-radius * Math.cos(angle)).toFixed(3)}`;
}).join("L")}Z`;
