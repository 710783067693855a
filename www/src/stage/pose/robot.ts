// The robot on a board: a body with wheels, and a nose where it looks. To the observers' boards it is a mere outline, for
// the reader.
import { nothing, type SVGTemplateResult, svg } from "lit";
import type { Cell } from "../../problem/types.js";
import type { BoardName } from "../board-input.js";

export type Facing = "north" | "east" | "south" | "west";

const turns: Record<Facing, number> = { north: 0, east: 90, south: 180, west: 270 };

/** `secret`: the reader is the enemy, and does not see it. */
export function robot(
  board: BoardName,
  [column, row]: Cell,
  scale: number,
  secret: boolean,
  facing: Facing | null,
  onGoal = false,
  cargo: SVGTemplateResult | typeof nothing = nothing,
) {
  if (secret) return nothing;
  // On a goal's cell it becomes an outline, so that the goal stays readable.
  const look = board === "actor" ? (onGoal ? "robot outline" : "robot") : "robot hidden";
  const half = onGoal ? 0.44 : 0.25;
  const nose =
    facing === null
      ? nothing
      : svg`<path class="nose" transform="rotate(${turns[facing]})" d=${`M-0.17 ${-half + 0.01}L0 ${-half - 0.19}L0.17 ${-half + 0.01}z`}></path>`;
  return svg`<g class=${look} transform="translate(${column + 0.5} ${row + 0.5}) scale(${scale})">
    <rect class="body" x=${-half} y=${-half} width=${2 * half} height=${2 * half} rx="0.14"></rect>${nose}${cargo}
  </g>`;
}

/** The ways in which an observer holds it possible that the robot looks, drawn as a small rose. */
export function rose(facings: readonly Facing[], [x, y]: Cell, size: number) {
  const all: Facing[] = ["north", "east", "south", "west"];
  return svg`<g class="rose" transform="translate(${x} ${y}) scale(${size})">${all.map(
    (facing) =>
      svg`<path class=${facings.includes(facing) ? "on" : "off"} transform="rotate(${turns[facing]})" d="M-0.16 -0.12L0 -0.46L0.16 -0.12z"></path>`,
  )}</g>`;
}
