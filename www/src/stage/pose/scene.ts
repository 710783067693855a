// What box pushing and the recycling robot have in common: a robot on a grid, and something that it moves.
import type { BeliefSummary, Scene, TraceStep } from "../../core.js";
import { keyOf } from "../../problem/cells.js";
import type { Cell } from "../../problem/types.js";
import type { Role } from "../../view/observers.js";
import type { BoardName } from "../board-input.js";

export type PoseScene = Extract<Scene, { format: "box-pushing" | "recycling-robot" }>;

/** A cell, and whether it is so in every believed state. */
export interface Spot {
  cell: Cell;
  sure: boolean;
}

const isCell = (value: unknown): value is Cell => Array.isArray(value);

/** Where a part of the state may be. */
export function spots({ shares, states }: BeliefSummary, part: string): Spot[] {
  return shares.flatMap((share) =>
    "part" in share && share.part === part && isCell(share.value)
      ? [{ cell: share.value, sure: share.states === states }]
      : [],
  );
}

/** The values that a part of the state may have, where they are no cells. */
export function values({ shares }: BeliefSummary, part: string): (string | number)[] {
  return shares.flatMap((share) =>
    "part" in share && share.part === part && !isCell(share.value) ? [share.value] : [],
  );
}

const nothing: BeliefSummary = { states: 0, shares: [], left_out: 0, goals: [] };

export const summaryOf = ({ summaries }: TraceStep, role: Role): BeliefSummary => summaries?.[role] ?? nothing;

/** The cells in which a board's observer holds the robot possible. */
export const believedCells = (name: BoardName, shown: TraceStep): Cell[] =>
  name === "actor" ? [] : spots(summaryOf(shown, name), "robot").map(({ cell }) => cell);

export const keysOfCells = (cells: readonly Cell[]): Set<string> => new Set(cells.map(keyOf));
