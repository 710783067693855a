// The candidate goals of a delivery: little sets of packages with the marks of the grid's goals.
import { nothing, svg } from "lit";
import { starPath } from "../../view/icons.js";
import type { BoardName } from "../board-input.js";
import { type GoalView, goalViews } from "../goal-attributes.js";
import { goalInWords, marks } from "../goal-marks.js";
import type { DeliveryInput } from "./facts.js";
import { WIDTH } from "./layout.js";
import { smallPackage } from "./package.js";

/** More would be too small to read; the list beside the boards has them all. */
const MOST = 30;
const SIZE = 0.72;
const CARD_HEIGHT = 1.3;

interface Cards {
  count: number;
  columns: number;
  width: number;
  height: number;
}

/** How the cards are laid out; without any where they would not be readable. */
export function cardsOf({ scene }: DeliveryInput): Cards {
  const width = scene.deliver * SIZE + 0.35;
  const columns = Math.floor(WIDTH / (width + 0.2));
  const count = columns === 0 || scene.goals.length > MOST ? 0 : scene.goals.length;
  return { count, columns, width, height: count === 0 ? 0 : Math.ceil(count / columns) * (CARD_HEIGHT + 0.35) + 0.4 };
}

export function goalCards(name: BoardName, input: DeliveryInput, cards: Cards, top: number) {
  if (cards.count === 0) return nothing;
  const pitch = cards.width + Math.min(0.6, (WIDTH - cards.columns * cards.width) / cards.columns);
  return goalViews(input.scene, input.shown).map((goal, index) =>
    card(
      name,
      goal,
      cards,
      (index % cards.columns) * pitch + 0.1,
      top + Math.floor(index / cards.columns) * (CARD_HEIGHT + 0.35),
    ),
  );
}

function card(name: BoardName, goal: GoalView, { width }: Cards, x: number, y: number) {
  const look = name === "actor" ? "plain" : goal.attributes[name];
  return svg`<g class="goal set ${look}" transform="translate(${x} ${y})" data-goal=${goal.name}
      data-adversarial=${goal.attributes.adversarial} data-cooperative=${goal.attributes.cooperative}
      ?data-true-goal=${goal.isTrue}>
    <title>${goal.name}${goal.isTrue ? " (true goal)" : ""}: ${goalInWords(goal)}</title>
    <rect class="badge" width=${width} height=${CARD_HEIGHT - 0.15} rx="0.2"></rect>
    ${goal.name.split("+").map((pack, index) => smallPackage(pack, pack, { x: 0.18 + index * SIZE, y: 0.2 }, SIZE - 0.08, "solid"))}
    ${look === "dead" ? svg`<line class="strike" x1="0.06" y1=${CARD_HEIGHT - 0.2} x2=${width - 0.06} y2="0.06"></line>` : nothing}
    ${name === "actor" ? svg`<g transform="translate(${width / 2} ${CARD_HEIGHT - 0.5}) scale(1.2)">${marks(goal, (width - 0.5) / 2.4)}</g>` : nothing}
    ${goal.isTrue ? svg`<path class="star" transform="translate(${width - 0.08} 0.06) scale(0.32)" d=${starPath}></path>` : nothing}
  </g>`;
}
