// The tools: what each is for, and what it takes hold of on which board.

import { sameCell } from "../problem/cells.js";
import type { Paint, Piece } from "../problem/drag.js";
import { isWall } from "../problem/grid-cells.js";
import { goalAt } from "../problem/grid-goals.js";
import { things } from "../problem/pose-cells.js";
import type { FloorDocument, ProblemDocument, Role } from "../problem/types.js";
import type { Boards } from "../state/boards.js";
import type { Cursor, Editing, Tool } from "../state/editing.js";
import { lockedText } from "../state/locks.js";
import type { OpenProblem } from "../state/open-problem.js";
import type { Timeline } from "../state/timeline.js";
import type { BoardName } from "../view/observers.js";

export interface ToolStores {
  problem: OpenProblem;
  boards: Boards;
  editing: Editing;
  timeline: Timeline;
}

export const toolNames: Record<Tool, string> = {
  move: "Move",
  walls: "Walls",
  belief: "First belief",
  cameras: "Cameras",
};

/** What a painting tool is for. */
const painting: Record<Exclude<Tool, "move">, string> = {
  walls: "Drag over cells to build walls. Begin on a wall to take walls away.",
  belief: "Drag over cells of the enemy’s or the friend’s board: where they think the agent may begin. Shows step 0.",
  cameras: "Drag over cells of the enemy’s or the friend’s board: there they see the agent exactly.",
};

/** The keys of a document that a tool changes. */
const keysOf: Record<Exclude<Tool, "move">, readonly string[]> = {
  walls: ["walls"],
  belief: ["observers"],
  cameras: ["observers"],
};

/** What is dragged on every board. */
const movable: Partial<Record<ProblemDocument["format"], Record<string, readonly string[]>>> = {
  gridworld: { start: ["the start"], goals: ["a goal"] },
  "box-pushing": { start: ["the robot", "the box"], goals: ["a goal"] },
  "recycling-robot": { start: ["the robot", "the can"], charger: ["the charger"], goals: ["a bin"] },
};

/** What a tool is for, and whether something of what it changes is not locked. */
export function useOf(tool: Tool, { problem }: Pick<ToolStores, "problem">): { about: string; possible: boolean } {
  const format = problem.latest?.format ?? "gridworld";
  const keys = tool === "move" ? [...Object.keys(movable[format] ?? {}), "walls"] : keysOf[tool];
  const locked = problem.lockedAmong(keys);
  const possible = locked.length < keys.length;
  if (!possible) return { about: lockedText(locked), possible };
  if (tool !== "move") return { about: painting[tool], possible };
  const names = Object.entries(movable[format] ?? {}).flatMap(([key, names]) => (locked.includes(key) ? [] : names));
  const [anywhere, wall] = problem.veiled.value ? ["", "a wall"] : [" on any board", "a wall on the agent’s"];
  const walls = locked.includes("walls") ? [] : [names.length === 0 ? "a wall on the agent’s board" : wall];
  const things = names.length === 0 ? [] : [`${either(names)}${anywhere}`];
  const drag = `Drag ${[...things, ...walls].join(", or ")}.`;
  const rest = locked.length > 0 ? ` ${lockedText(locked)}` : "";
  return { about: `${drag}${problem.closed.value ? "" : " The best plan follows at once."}${rest}`, possible };
}

const either = (names: readonly string[]): string =>
  names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} or ${names.at(-1)}`;

export const tools = Object.keys(toolNames) as Tool[];

/** What a painting tool paints on a board; null where it has nothing to paint there. */
export function paintOf(tool: Tool, board: BoardName): Paint | null {
  if (tool === "walls") return { kind: "wall" };
  if (board === "actor" || tool === "move") return null;
  return { kind: tool === "belief" ? "belief" : "camera", role: board };
}

/** What stands in a cell and may be carried on this board: a goal is drawn above the start. */
export function pieceAt(document: FloorDocument, board: BoardName, cell: Cursor["cell"]): Piece | null {
  const index = goalAt(document, cell);
  if (index >= 0) return { kind: "goal", index };
  if (document.format === "gridworld") {
    if (sameCell(document.start, cell)) return { kind: "start" };
  } else {
    const thing = things(document)
      .filter(([, place]) => sameCell(place, cell))
      .at(-1)?.[0];
    if (thing !== undefined) return { kind: "thing", thing };
  }
  if (board === "actor" && isWall(document, cell)) return { kind: "wall" };
  return null;
}

/** The grid that the next edit starts from; null where there is none, or where the boards are not for editing now. */
export function editable({
  problem: { latest },
  boards: { mode },
}: Pick<ToolStores, "problem" | "boards">): FloorDocument | null {
  return latest !== null && isFloor(latest) && mode.value === "plan" ? latest : null;
}

const floors: readonly ProblemDocument["format"][] = ["gridworld", "box-pushing", "recycling-robot"];

export const isFloor = (document: ProblemDocument): document is FloorDocument => floors.includes(document.format);

const onAgentsBoard: readonly Tool[] = ["move", "walls"];

/**
 * Where a robot stands is not all that is believed of it: its first beliefs are written as text. Where the observers' boards
 * are veiled, nothing can be painted on them.
 */
export const toolsFor = (
  format: ProblemDocument["format"],
  { veiled }: Pick<OpenProblem, "veiled">,
): readonly Tool[] => {
  if (!floors.includes(format)) return [];
  return format === "gridworld" && !veiled.value ? tools : onAgentsBoard;
};

/** The tool in the hand; one that the problem open now has no use for, or that is locked, is put down. */
export const toolInHand = ({ editing, problem }: Pick<ToolStores, "editing" | "problem">): Tool => {
  const tool = editing.tool.value;
  const offered = problem.latest !== null && toolsFor(problem.latest.format, problem).includes(tool);
  return offered && useOf(tool, { problem }).possible ? tool : "move";
};

export const roleOf = (board: BoardName): Role | null => (board === "actor" ? null : board);

/** Takes a tool. First beliefs are those of step 0. */
export function take(playground: Pick<ToolStores, "editing" | "timeline">, tool: Tool): void {
  playground.editing.tool.value = tool;
  if (tool === "belief") playground.timeline.goTo(0);
}
