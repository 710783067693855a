// What the article says of a figure in words: which symbols name what, where something is, and which form a belief has. The
// answers come from the figures' documents and from the core.
import assert from "node:assert/strict";
import { documentOf, planOf } from "../../../scripts/learn/figures.mjs";
import { Problem } from "../../../www/pkg/mo_copp.js";
import { replay } from "./core.js";

type Options = Record<string, string>;
type Cell = readonly [column: number, row: number];

interface Floor {
  width: number;
  height: number;
  walls?: Cell[];
  start: Cell;
  goals: { name: string; cell: Cell }[];
  true_goal: string;
  observers: Record<string, { cameras?: Cell[]; sensor: Record<string, string | Record<string, string>> }>;
}

const floorOf = (figure: string): Floor => JSON.parse(documentOf(figure));
const observerOf = (figure: string, { of }: Options) =>
  floorOf(figure).observers[of === "enemy" ? "adversarial" : "cooperative"] ?? assert.fail(`${figure} has no ${of}`);
const roleOf = ({ of }: Options) => (of === "enemy" ? "adversarial" : "cooperative");
const listed = (cells: readonly unknown[]) =>
  cells
    .map((cell) => JSON.stringify(cell))
    .sort()
    .join(" ");

function stepOf(figure: string, { plan = "", step = "-1" }: Options) {
  const { steps } = replay(documentOf(figure), planOf(figure, plan));
  return steps.at(Number(step)) ?? assert.fail(`${figure} has no step ${step}`);
}

function beliefOf(figure: string, options: Options): Cell[] {
  return stepOf(figure, options).beliefs[roleOf(options)] as unknown as Cell[];
}

function goalCell(figure: string, name: string): Cell {
  return floorOf(figure).goals.find((goal) => goal.name === name)?.cell ?? assert.fail(`${figure} has no goal ${name}`);
}

/** Whether a cell is in the middle of a floor, in a corner of it, or neither. */
function placeOf({ width, height }: Floor, [column, row]: Cell): string {
  if (2 * column === width - 1 && 2 * row === height - 1) return "middle";
  return [0, width - 1].includes(column) && [0, height - 1].includes(row) ? "corner" : "elsewhere";
}

const cellsOf = ({ width, height }: Floor): Cell[] =>
  Array.from({ length: width * height }, (_, index) => [index % width, Math.floor(index / width)] as const);

/** The cells beside one that are no walls. */
function beside(floor: Floor, [column, row]: Cell): Cell[] {
  const walls = (floor.walls ?? []).map(String);
  return cellsOf(floor).filter(
    (cell) => Math.abs(cell[0] - column) + Math.abs(cell[1] - row) === 1 && !walls.includes(String(cell)),
  );
}

/** The cells that can be come to from one without passing another. */
function reached(floor: Floor, from: Cell, without: Cell): string[] {
  const known = [from];
  for (const cell of known)
    for (const next of beside(floor, cell))
      if (String(next) !== String(without) && !known.some((one) => String(one) === String(next))) known.push(next);
  return known.map(String);
}

const distance = (floor: Floor, from: Cell, to: Cell): number => {
  const known = new Map([[String(from), 0]]);
  const queue = [from];
  for (const cell of queue)
    for (const next of beside(floor, cell))
      if (!known.has(String(next))) {
        known.set(String(next), (known.get(String(cell)) ?? 0) + 1);
        queue.push(next);
      }
  return known.get(String(to)) ?? assert.fail(`${to} cannot be reached`);
};

/** `square`: the corners of one, and nothing else; `slanted`: a diagonal line without gaps. */
function shapeOf(cells: readonly Cell[]): string {
  const [columns, rows] = [0, 1].map((axis) => [...new Set(cells.map((cell) => cell[axis] as number))].sort());
  const [left = 0, right = 0] = columns ?? [];
  const [top = 0, bottom = 0] = rows ?? [];
  const two = columns?.length === 2 && rows?.length === 2 && cells.length === 4;
  if (two && right - left === bottom - top) return "square";
  const sorted = [...cells].sort((one, other) => one[0] - other[0]);
  const steps = sorted.slice(1).map((cell, index) => {
    const [column, row] = sorted[index] ?? assert.fail();
    return `${cell[0] - column},${cell[1] - row}`;
  });
  const slanted = steps.length > 0 && new Set(steps).size === 1 && /^1,-?1$/.test(steps[0] ?? "");
  return slanted ? "slanted" : "other";
}

/** The cells that plans to the true goal end in: the goal's, where a plan leads there. */
function ends(figure: string): string {
  const problem = new Problem(documentOf(figure));
  const known = new Map<string, unknown>();
  const ended = new Map<string, unknown>();
  let plans: string[][] = [[]];
  while (plans.length > 0) {
    const further: string[][] = [];
    for (const plan of plans)
      for (const { action, state, goal } of problem.next(plan)) {
        const key = JSON.stringify(state);
        if (goal) ended.set(key, state);
        if (known.has(key)) continue;
        known.set(key, state);
        further.push([...plan, action]);
      }
    plans = further;
  }
  return listed([...ended.values()]);
}

export const said: Record<string, (figure: string, options: Options) => string | number> = {
  /** Whether each symbol is that of just these moves, and no move has another: `tick=north,south`. */
  tells: (figure, { of = "", ...symbols }) => {
    const { sensor } = observerOf(figure, { of });
    const moves = (symbol: string) => Object.keys(sensor).filter((move) => sensor[move] === symbol);
    const right = Object.entries(symbols).every(([symbol, told]) => listed(moves(symbol)) === listed(told.split(",")));
    return right && Object.values(sensor).every((symbol) => String(symbol) in symbols) ? "yes" : "no";
  },
  /** How many different symbols loading has. */
  loads: (figure, options) => {
    const { load = "" } = observerOf(figure, options).sensor;
    return typeof load === "string" ? 1 : new Set(Object.values(load)).size;
  },
  /** The symbol that an observer is told at a step. */
  symbol: (figure, options) => stepOf(figure, options).symbols[roleOf(options)] ?? "nothing",
  /** Where the start is, or a goal. */
  place: (figure, { at = "" }) => {
    const floor = floorOf(figure);
    return placeOf(floor, at === "start" ? floor.start : goalCell(figure, at));
  },
  "cells-at": (figure, { places = "" }) => {
    const floor = floorOf(figure);
    return listed(cellsOf(floor).filter((cell) => places.split(",").includes(placeOf(floor, cell))));
  },
  shape: (figure, options) => shapeOf(beliefOf(figure, options)),
  camera: (figure, options) => listed(observerOf(figure, options).cameras ?? []),
  /** The cell of the true goal. */
  goal: (figure) => listed([goalCell(figure, floorOf(figure).true_goal)]),
  ends,
  /** The cell that parts the goals of a room from the start, and has a wall on two sides. */
  door: (figure, { rooms = "" }) => {
    const floor = floorOf(figure);
    const inside = rooms.split(",").map((name) => goalCell(figure, name));
    return listed(
      cellsOf(floor).filter((cell) => {
        if (String(cell) === String(floor.start) || inside.some((goal) => String(goal) === String(cell))) return false;
        const open = reached(floor, floor.start, cell);
        const walled = beside(floor, cell).length === 2;
        return walled && inside.every((goal) => !open.includes(String(goal)));
      }),
    );
  },
  /** Whether each step up to one leads farther from a goal. */
  away: (figure, { plan = "", step = "", from = "" }) => {
    const floor = floorOf(figure);
    const { steps } = replay(documentOf(figure), planOf(figure, plan));
    const far = steps
      .slice(0, Number(step) + 1)
      .map(({ state }) => distance(floor, state as unknown as Cell, goalCell(figure, from)));
    return far.slice(1).every((distance, index) => distance > (far[index] ?? 0)) ? "yes" : "no";
  },
  /** How far the farthest cell of a floor is from its start. */
  farthest: (figure) => {
    const floor = floorOf(figure);
    const walls = (floor.walls ?? []).map(String);
    const cells = cellsOf(floor).filter((cell) => !walls.includes(String(cell)));
    return Math.max(...cells.map((cell) => distance(floor, floor.start, cell)));
  },
};
