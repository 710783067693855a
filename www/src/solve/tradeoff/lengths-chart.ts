// The best goal difference of every plan length: a point for each length that has a plan, a cross for each that has
// none, and a line for the best of at most so many moves.
import { html, svg, type TemplateResult } from "lit";
import type { LengthPoint } from "../../core.js";
import { differenceText } from "../../view/numbers.js";
import { isFeasible, type ShownLength } from "./length-points.js";
import { pointKeys, pointView } from "./points.js";

const WIDTH = 346;
const LEFT = 38;
const RIGHT = 12;
const TOP = 26;
const PLOT = 210;
const HEIGHT = TOP + PLOT + 60;
const CROSSES = TOP + PLOT + 12;
const MOST_LABELS = 10;

export function lengthsChart(points: readonly ShownLength[], lengths: readonly LengthPoint[]): TemplateResult {
  const shortest = points[0]?.length ?? 0;
  // Two lengths without a plan say enough of all shorter ones.
  const drawn = lengths.filter(({ length }) => length >= shortest - 2);
  const [from, to] = [drawn[0]?.length ?? 0, drawn.at(-1)?.length ?? 0];
  const low = Math.min(0, ...points.map((point) => point.goal_difference)) < 0 ? -1 : 0;
  const column = (WIDTH - LEFT - RIGHT) / (to - from + 1);
  const x = (length: number) => LEFT + (length - from + 0.5) * column;
  const y = (value: number) => TOP + ((1 - value) / (1 - low)) * PLOT;
  const every = Math.ceil((to - from + 1) / MOST_LABELS);
  const ticks = low === 0 ? [0, 0.25, 0.5, 0.75, 1] : [-1, -0.5, 0, 0.5, 1];
  const size = Math.min(4, column * 0.3);
  return html`<svg class="chart" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="group" @keydown=${pointKeys}
    aria-label="The best goal difference of each plan length">
    <g aria-hidden="true">
      <rect class="plot" x=${LEFT} y=${TOP - 8} width=${WIDTH - LEFT - RIGHT} height=${PLOT + 28} rx="6"></rect>
      ${ticks.map(
        (tick) => svg`<line class="same" x1=${LEFT} x2=${WIDTH - RIGHT} y1=${y(tick)} y2=${y(tick)}></line>
          <text class="tick" x=${LEFT - 6} y=${y(tick) + 4} text-anchor="end">${differenceText(tick)}</text>`,
      )}
      ${drawn.map(({ length }) =>
        (length - shortest) % every === 0
          ? svg`<text class="tick" x=${x(length)} y=${TOP + PLOT + 36} text-anchor="middle">${length}</text>`
          : "",
      )}
      <text class="axis" x=${(LEFT + WIDTH - RIGHT) / 2} y=${HEIGHT - 6} text-anchor="middle">moves →</text>
      <text class="value" x="2" y="12">goal difference</text>
      <path class="so-far" d=${soFar(points, x, y, x(to) + column / 2)}></path>
      ${drawn
        .filter((point) => !isFeasible(point))
        .map(({ length }) => {
          const at = x(length);
          return svg`<path class="none" d="M${at - size} ${CROSSES - size}l${2 * size} ${2 * size}m0 ${-2 * size}l${-2 * size} ${2 * size}"></path>`;
        })}
    </g>
    ${points.map((point, index) => {
      const [cx, cy] = [x(point.length), y(point.goal_difference)];
      const left = index === 0 ? LEFT : (x(points[index - 1]?.length ?? 0) + cx) / 2;
      const next = points[index + 1];
      const right = next === undefined ? WIDTH - RIGHT : (x(next.length) + cx) / 2;
      return pointView({
        ...point,
        x: cx,
        y: cy,
        area: { x: left, y: TOP - 8, width: right - left, height: PLOT + 28 },
        kind: point.best ? "best" : "plain",
        mark: svg`<circle class="dot" cx=${cx} cy=${cy} r=${point.best ? 6.5 : 4.5}></circle>`,
      });
    })}
  </svg>`;
}

/** Steps up wherever a longer plan is better than every shorter one. */
function soFar(
  points: readonly ShownLength[],
  x: (length: number) => number,
  y: (value: number) => number,
  end: number,
) {
  let best = Number.NEGATIVE_INFINITY;
  let path = "";
  for (const { length, goal_difference } of points) {
    if (goal_difference <= best) continue;
    path += path === "" ? `M${x(length)} ${y(goal_difference)}` : `H${x(length)}V${y(goal_difference)}`;
    best = goal_difference;
  }
  return path === "" ? "" : `${path}H${end}`;
}
