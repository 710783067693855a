// A board of a robot on a grid: the cells and goals of every grid, and on top what the domain adds.

import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import { boardMarks } from "../../gesture/board-marks.js";
import { boardBlur, boardFocus, boardKey } from "../../gesture/keys.js";
import { boardPointer } from "../../gesture/pointer.js";
import { times } from "../../problem/times.js";
import type { Cell } from "../../problem/types.js";
import { enlarged, isLarge } from "../../view/scale.js";
import type { BoardInput, BoardName } from "../board-input.js";
import { goalViews } from "../goal-attributes.js";
import { start } from "../grid/agent.js";
import { boardClasses } from "../grid/board.js";
import { cellLayer } from "../grid/cell-layer.js";
import { goalMarks } from "../grid/goal.js";
import { dots, squares } from "../grid/marks.js";
import type { BoardStores } from "../view.js";
import { reasonMarks } from "../why.js";
import { believedCells, keysOfCells, type PoseScene } from "./scene.js";

const MARGIN = 0.06;

export interface PoseParts {
  /** Under the goals: the box, the charger. */
  under: SVGTemplateResult | typeof nothing;
  /** Over them: the robot. */
  over: SVGTemplateResult | typeof nothing;
  /** Below the grid, so many cells high. */
  below?: { height: number; drawn: SVGTemplateResult };
  label: string;
  at: Cell;
}

export function poseBoard(
  name: BoardName,
  input: BoardInput<PoseScene>,
  playground: BoardStores,
  parts: PoseParts,
): TemplateResult {
  const { scene, shown } = input;
  const { width, height, walls } = scene;
  const scale = enlarged(scene);
  const believed = believedCells(name, shown);
  const bottom = parts.below?.height ?? 0;
  const box = `${-MARGIN} ${-MARGIN} ${width + 2 * MARGIN} ${height + bottom + 2 * MARGIN}`;
  const pointer = boardPointer(name, playground);
  return html`<svg class=${`${boardClasses(scene, playground)} pose`} data-board=${name} viewBox=${box}
    role="application" tabindex="0" aria-label=${parts.label} aria-roledescription="board"
    @pointerdown=${pointer.down} @pointermove=${pointer.move} @pointerup=${pointer.up} @pointercancel=${pointer.lost}
    @lostpointercapture=${pointer.lost} @touchstart=${pointer.touch}
    @keydown=${boardKey(name, playground)} @focus=${boardFocus(name, playground)} @blur=${boardBlur(playground)}>
    ${
      isLarge(scene)
        ? svg`<path class="floor" d=${squares(everywhere(scene))}></path><path class="believed" d=${squares(believed)}></path><path class="wall" d=${squares(walls)}></path>`
        : nothing
    }
    <g ${cellLayer({ width, height, walls, believed: keysOfCells(believed) })}></g>
    ${start(scene.start.robot, scene.goals, scale)}
    ${name === "actor" ? path(input) : nothing}
    ${parts.under}
    <path class="dot" d=${dots(believed)}></path>
    ${name === "actor" ? nothing : reasonMarks(name, playground)}
    ${goalMarks(
      name,
      goalViews(scene, shown),
      scene.goals.map(({ cell }) => cell),
      scale,
    )}
    ${parts.over} ${boardMarks(name, playground)}
    ${parts.below === undefined ? nothing : svg`<g transform="translate(0 ${height})">${parts.below.drawn}</g>`}
  </svg>`;
}

const everywhere = ({ width, height }: PoseScene): Cell[] =>
  times(width * height, (index) => [index % width, Math.floor(index / width)]);

/** The robot's way: walked as a line, to come as dots. */
function path({ trace, step }: BoardInput<PoseScene>) {
  const points = trace.steps.map(({ state }) => {
    const [column, row] = robotCell(state);
    return `${column + 0.5},${row + 0.5}`;
  });
  return svg`<polyline class="ahead" points=${points.slice(step).join(" ")}></polyline>
    <polyline class="walked" points=${points.slice(0, step + 1).join(" ")}></polyline>`;
}

export function robotCell(state: unknown): Cell {
  const robot = typeof state === "object" && state !== null && "robot" in state ? state.robot : null;
  return Array.isArray(robot) ? [Number(robot[0]), Number(robot[1])] : [0, 0];
}
