// The pairs of survivor counts that plans can reach, as points in a grid: the friend's to the right, the enemy's up.
// The slanted lines join pairs of one goal difference, which is written where they end.
import { html, svg, type TemplateResult } from "lit";
import { differenceText } from "../../view/numbers.js";
import type { Bounds, PairPoint } from "./pair-points.js";
import { pointKeys, pointView } from "./points.js";

const SIDE = 264;
const LEFT = 38;
const TOP = 34;
const WIDTH = LEFT + SIDE + 48;
const HEIGHT = TOP + SIDE + 42;
/** More would run into each other. */
const MOST_LABELS = 9;

export function pairsChart(points: readonly PairPoint[], goals: number, bounds: Bounds): TemplateResult {
  const cell = SIDE / goals;
  const x = (friend: number) => LEFT + (friend - 0.5) * cell;
  const y = (enemy: number) => TOP + (goals - enemy + 0.5) * cell;
  const radius = Math.max(3, Math.min(8, cell * 0.3));
  const every = Math.ceil(goals / MOST_LABELS);
  const counts = [...Array(goals).keys()].map((index) => index + 1);
  const labelled = (count: number) => (count - 1) % every === 0;
  return html`<svg class="chart" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="group" @keydown=${pointKeys}
    aria-label="Goals possible for the enemy against goals possible for the friend">
    <g aria-hidden="true">
      <rect class="plot" x=${LEFT} y=${TOP} width=${SIDE} height=${SIDE} rx="6"></rect>
      ${diagonals(goals).map(
        ([from, to]) => svg`<line class="same" x1=${x(from[0])} y1=${y(from[1])} x2=${x(to[0])} y2=${y(to[1])}></line>`,
      )}
      ${counts.filter(labelled).map(
        (count) => svg`<text class="tick" x=${x(count)} y=${TOP + SIDE + 15} text-anchor="middle">${count}</text>
          <text class="tick" x=${LEFT - 8} y=${y(count) + 4} text-anchor="end">${count}</text>`,
      )}
      ${counts.filter(labelled).map((count) => {
        const above = differenceText(difference(goals, count, goals));
        const beside = differenceText(difference(count, goals, goals));
        return svg`<text class="value" x=${x(count)} y=${TOP - 7} text-anchor="middle">${above}</text>
          ${count === goals ? "" : svg`<text class="value" x=${LEFT + SIDE + 5} y=${y(count) + 4}>${beside}</text>`}`;
      })}
      <text class="value" x=${LEFT} y="12">goal difference along the lines</text>
      <text class="axis friend" x=${LEFT + SIDE / 2} y=${HEIGHT - 6} text-anchor="middle">possible for the friend →</text>
      <text class="axis enemy" transform="translate(11 ${TOP + SIDE / 2}) rotate(-90)" text-anchor="middle">possible for the enemy →</text>
      ${
        bounds.k === undefined
          ? ""
          : svg`<line class="bound enemy" x1=${LEFT} x2=${LEFT + SIDE} y1=${y(bounds.k - 0.5)} y2=${y(bounds.k - 0.5)}></line>
              <text class="bound enemy" x=${LEFT + SIDE - 4} y=${y(bounds.k - 0.5) - 4} text-anchor="end">k = ${bounds.k}</text>`
      }
      ${
        bounds.j === undefined
          ? ""
          : svg`<line class="bound friend" x1=${x(bounds.j + 0.5)} x2=${x(bounds.j + 0.5)} y1=${TOP} y2=${TOP + SIDE}></line>
              <text class="bound friend" x=${x(bounds.j + 0.5) - 4} y=${TOP + SIDE - 6} text-anchor="end">j = ${bounds.j}</text>`
      }
    </g>
    ${points.map((point) => {
      const [cx, cy] = [x(point.cooperative), y(point.adversarial)];
      return pointView({
        ...point,
        x: cx,
        y: cy,
        area: { x: cx - cell / 2, y: cy - cell / 2, width: cell, height: cell },
        kind: point.outside ? "outside" : point.best ? "best" : "plain",
        mark: svg`<circle class="dot" cx=${cx} cy=${cy} r=${point.best ? radius + 2 : radius}></circle>`,
      });
    })}
  </svg>`;
}

/** For each goal difference, from where to where its line crosses the grid. */
function diagonals(goals: number): [from: [number, number], to: [number, number]][] {
  return [...Array(2 * goals - 1).keys()].map((index) => {
    const ahead = index + 1 - goals;
    const from = Math.max(1, 1 - ahead);
    const to = Math.min(goals, goals - ahead);
    return [
      [from - 0.5, from + ahead - 0.5],
      [to + 0.5, to + ahead + 0.5],
    ];
  });
}

export const difference = (adversarial: number, cooperative: number, goals: number): number =>
  (adversarial - cooperative) / (goals - 1);
