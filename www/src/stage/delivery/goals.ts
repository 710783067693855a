// The candidate goals of a delivery: little sets of packages with the marks of the grid's goals.
import { nothing, svg } from "lit";
import { starPath } from "../../view/icons.js";
import type { BoardName } from "../board-input.js";
import { type GoalView, goalViews } from "../goal-attributes.js";
import { goalTold, looks, marks } from "../goal-marks.js";
import type { DeliveryInput } from "./facts.js";
import { WIDTH } from "./layout.js";
import { smallPackage } from "./package.js";

/** More would be too small to read; the list beside the boards has them all. */
const MOST = 30;
/** How large the packages of a goal are drawn: as large as three rows allow. */
const SIZES = [1.15, 0.95, 0.75];
const ROWS = 3;

interface Cards {
  count: number;
  columns: number;
  width: number;
  height: number;
  /** The width of a package. */
  size: number;
}

/** How the cards are laid out; without any where they would not be readable. */
export function cardsOf({ scene }: DeliveryInput): Cards {
  const fits = (size: number) => {
    const width = scene.deliver * size + 0.35;
    const columns = Math.floor(WIDTH / (width + 0.15));
    return {
      width,
      columns,
      size,
      rows: columns === 0 ? Number.POSITIVE_INFINITY : Math.ceil(scene.goals.length / columns),
    };
  };
  const choices = SIZES.map(fits);
  const best = choices.find(({ rows }) => rows <= ROWS) ?? choices.at(-1);
  const count = best === undefined || best.columns === 0 || scene.goals.length > MOST ? 0 : scene.goals.length;
  const { width = 0, columns = 0, size = 0, rows = 0 } = best ?? {};
  return { count, columns, width, size, height: count === 0 ? 0 : rows * (size + 0.85) + 0.3 };
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
      top + Math.floor(index / cards.columns) * (cards.size + 0.85),
    ),
  );
}

function card(name: BoardName, goal: GoalView, { width, size }: Cards, x: number, y: number) {
  const height = size + 0.4;
  const look = name === "actor" ? "plain" : looks[goal.standing[name]];
  return svg`<g class="goal set ${look}" transform="translate(${x} ${y})" data-goal=${goal.name}
      data-adversarial=${goal.attributes.adversarial} data-cooperative=${goal.attributes.cooperative}
      ?data-true-goal=${goal.isTrue}>
    <title>${goalTold(goal)}</title>
    <rect class="badge" width=${width} height=${height} rx="0.2"></rect>
    ${goal.name.split("+").map((pack, index) => smallPackage(pack, pack, { x: 0.18 + index * size, y: 0.16 }, size - 0.08, "solid"))}
    ${look === "dead" ? svg`<line class="strike" x1="0.06" y1=${height - 0.06} x2=${width - 0.06} y2="0.06"></line>` : nothing}
    ${name === "actor" ? svg`<g transform="translate(${width / 2} ${height - 0.41}) scale(1.4)">${marks(goal, (width - 0.5) / 2.8)}</g>` : nothing}
    ${goal.isTrue ? svg`<path class="star" transform="translate(${width - 0.08} 0.06) scale(0.32)" d=${starPath}></path>` : nothing}
  </g>`;
}
