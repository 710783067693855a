// Walking by key and by touch, on the agent's board.
import { svg, type TemplateResult } from "lit";
import type { Scene, State } from "../core.js";
import type { Boards } from "../state/boards.js";
import type { Timeline } from "../state/timeline.js";
import type { Walk } from "../state/walk.js";
import { icon } from "../view/icons.js";

export interface WalkKeyStores {
  boards: Boards;
  timeline: Timeline;
  walk: Walk;
}

const arrow = (turn: number): TemplateResult =>
  icon(svg`<path transform="rotate(${turn} 8 8)" d="M8 2.5l5 6H10v5H6v-5H3z"></path>`);

export const arrows: Record<string, { action: string; sign: TemplateResult; columns: number; rows: number }> = {
  ArrowUp: { action: "north", sign: arrow(0), columns: 0, rows: -1 },
  ArrowLeft: { action: "west", sign: arrow(270), columns: -1, rows: 0 },
  ArrowRight: { action: "east", sign: arrow(90), columns: 1, rows: 0 },
  ArrowDown: { action: "south", sign: arrow(180), columns: 0, rows: 1 },
};

/** The keys of each kind of board, and the actions they are for. */
const keysOf: Partial<Record<Scene["format"], Record<string, string>>> = {
  gridworld: directions({ s: "stay", ".": "stay" }),
  "box-pushing": {
    ...{ ArrowUp: "move-forward", ArrowLeft: "turn-left", ArrowRight: "turn-right" },
    ...{ s: "stay", ".": "stay" },
  },
  "recycling-robot": directions({ s: "stay", ".": "stay", p: "pick-up", d: "drop", c: "charge" }),
};

function directions(more: Record<string, string>): Record<string, string> {
  return { ...Object.fromEntries(Object.entries(arrows).map(([key, { action }]) => [key, action])), ...more };
}

/** Whether there is a board to walk on. */
export const hasWalkKeys = ({ format }: Scene): boolean => keysOf[format] !== undefined;

/** Takes the action of a key pressed on the agent's board; true where the key was one. */
export function walkByKey(playground: WalkKeyStores, event: KeyboardEvent): boolean {
  if (playground.boards.mode.value !== "walk" || event.altKey || event.ctrlKey || event.metaKey) return false;
  if (event.key === "Backspace") {
    event.preventDefault();
    void playground.walk.back();
    return true;
  }
  const action = keysOf[playground.boards.scene.value?.format ?? "explicit"]?.[event.key];
  if (action === undefined) return false;
  event.preventDefault();
  void playground.walk.take(action);
  return true;
}

/** Walks to a cell beside the agent, or stays on its own. */
function walkToCell(playground: WalkKeyStores, column: number, row: number): void {
  const here = standing(playground.timeline.shown.value?.state);
  // A robot that turns does not go where one points.
  if (
    playground.boards.mode.value !== "walk" ||
    here === null ||
    playground.boards.scene.value?.format === "box-pushing"
  )
    return;
  const [columns, rows] = [column - here[0], row - here[1]];
  const action =
    columns === 0 && rows === 0
      ? "stay"
      : Object.values(arrows).find((way) => way.columns === columns && way.rows === rows)?.action;
  if (action !== undefined) void playground.walk.take(action);
}

function standing(state: State | undefined): [number, number] | null {
  const cell = typeof state === "object" && "robot" in state ? state.robot : state;
  return Array.isArray(cell) ? [Number(cell[0]), Number(cell[1])] : null;
}

/** The cell of a grid's board under the pointer. */
export function walkByPointer(playground: WalkKeyStores, event: MouseEvent): void {
  const board = (event.currentTarget as HTMLElement).querySelector<SVGSVGElement>("svg.board");
  const toScreen = board?.getScreenCTM();
  if (!board || !toScreen) return;
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(toScreen.inverse());
  walkToCell(playground, Math.floor(point.x), Math.floor(point.y));
}
