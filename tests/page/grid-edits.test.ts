// Edits of grid documents, without a browser: what each does, and that the core takes whatever comes of them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { paintOf, pieceAt, tools } from "../../www/src/gesture/tools.js";
import { between, everyCell } from "../../www/src/problem/cells.js";
import { carry, type Drag, draggedTo, stroke } from "../../www/src/problem/drag.js";
import * as cells from "../../www/src/problem/grid-cells.js";
import * as goals from "../../www/src/problem/grid-goals.js";
import * as sensor from "../../www/src/problem/grid-sensor.js";
import { type Resized, resized } from "../../www/src/problem/grid-size.js";
import { newGrid } from "../../www/src/problem/new-grid.js";
import { written } from "../../www/src/problem/text.js";
import type { Cell, GridworldDocument, Role } from "../../www/src/problem/types.js";
import { example, taken } from "./support/core.js";
import { Dice } from "./support/dice.js";

const eight = JSON.parse(example) as GridworldDocument;
const roles: readonly Role[] = ["adversarial", "cooperative"];
const belief = (document: GridworldDocument, role: Role) => cells.beliefOf(document, role).map(String).sort();

test("the start takes along who took the agent to be there", () => {
  const moved = cells.moveStart(eight, [4, 7]);
  assert.deepEqual(moved.start, [4, 7]);
  assert.deepEqual(belief(moved, "adversarial"), ["1,6", "2,7", "4,7"]);
  // The friend knew the start: it goes on to.
  assert.equal(moved.observers.cooperative.initial_belief, undefined);
  // Onto a cell that was held possible: nothing is forgotten.
  assert.deepEqual(belief(cells.moveStart(eight, [1, 6]), "adversarial"), ["0,7", "1,6", "2,7"]);
  for (const wall of [
    [0, 3],
    [-1, 0],
    [8, 0],
  ] as Cell[])
    assert.equal(cells.moveStart(eight, wall), eight);
});

test("goals may share a cell, also with the start, and stand in no wall", () => {
  assert.deepEqual(goals.goalAt(cells.moveGoal(eight, 1, [7, 0]), [7, 0]), 1);
  assert.deepEqual(cells.moveGoal(eight, 1, [0, 7]).goals[1]?.cell, [0, 7]);
  assert.equal(cells.moveGoal(eight, 1, [2, 1]), eight);
});

test("a wall drives beliefs out of its cell, and stands on neither start nor goal", () => {
  const walled = cells.setWall(eight, [1, 6], true);
  assert.deepEqual(belief(walled, "adversarial"), ["0,7", "2,7"]);
  assert.equal(cells.setWall(eight, [0, 7], true), eight);
  assert.equal(cells.setWall(eight, [7, 0], true), eight);
  assert.equal(cells.setWall(eight, [5, 0], false), eight);
  const moved = cells.moveWall(eight, [2, 1], [1, 6]);
  assert.deepEqual([cells.isWall(moved, [2, 1]), cells.isWall(moved, [1, 6])], [false, true]);
  for (const to of [
    [0, 7],
    [7, 0],
    [3, 2],
    [8, 8],
  ] as Cell[])
    assert.equal(cells.moveWall(eight, [2, 1], to), eight);
});

test("the start stays in a first belief; the start alone is not written down", () => {
  assert.equal(cells.setBelieved(eight, "adversarial", [0, 7], false), eight);
  assert.equal(cells.setBelieved(eight, "adversarial", [2, 1], true), eight);
  const alone = cells.believeStart(eight, "adversarial");
  assert(!("initial_belief" in alone.observers.adversarial));
  assert.equal(belief(cells.believeEverywhere(eight, "cooperative"), "cooperative").length, 64 - 11);
});

function shrunk(document: GridworldDocument, width: number, height: number): Resized {
  const smaller = resized(document, width, height);
  return typeof smaller === "string" ? assert.fail(smaller) : smaller;
}

test("smaller keeps what fits, and moves what does not to the nearest free cell", () => {
  const { document, changes } = shrunk(eight, 4, 4);
  assert.deepEqual(document.walls?.map(String), ["0,3", "1,3", "2,1", "3,2"]);
  assert.deepEqual(document.start, [0, 2]);
  assert.deepEqual(
    document.goals.map(({ cell }) => String(cell)),
    ["3,0", "3,3", "1,0", "2,3"],
  );
  assert.deepEqual(belief(document, "adversarial"), ["0,2"]);
  assert.deepEqual(changes, [
    "the start moved to column 0, row 2",
    "G1 moved to column 3, row 0",
    "G2 moved to column 3, row 3",
    "G4 moved to column 2, row 3",
    "7 walls vanished",
  ]);
  assert.deepEqual(shrunk(eight, 9, 12).changes, []);
  // All that is left is walls.
  const full = {
    ...newGrid(3, 3),
    walls: [
      [0, 0],
      [1, 0],
      [0, 1],
      [1, 1],
    ] as Cell[],
    start: [2, 2] as Cell,
  };
  full.goals = full.goals.map((goal) => ({ ...goal, cell: [2, 2] }));
  const small = shrunk(full, 2, 2).document;
  assert(taken(written(small)));
  assert.equal(small.walls?.length, 3);
});

test("smaller puts no two goals into one cell, nor a goal onto the start, or is refused", () => {
  for (const [width, height] of [
    [8, 2],
    [2, 8],
    [4, 4],
    [3, 3],
  ] as const) {
    const { start, goals: moved } = shrunk(eight, width, height).document;
    const places = new Set([start, ...moved.map(({ cell }) => cell)].map(String));
    assert.equal(places.size, 5, `${width} by ${height}: ${[...places].join(" ")}`);
  }
  // With a cell for each goal and none left over, the start is on one of them, and that is said.
  const least = shrunk(eight, 2, 2);
  assert.equal(new Set(least.document.goals.map(({ cell }) => String(cell))).size, 4);
  assert.match(least.changes[0] ?? "", /^the start moved to column 0, row 1, where G\d is$/);
  const five = goals.addGoal(eight, [4, 4]) as GridworldDocument;
  assert.equal(
    resized(five, 2, 2),
    "Too small: there are 4 free cells for the goals’ 5 places. Remove goals or walls first.",
  );
  // Goals that shared a cell before still do.
  const [first, ...others] = eight.goals;
  const shared = { ...eight, goals: [first, ...others.map((goal) => ({ ...goal, cell: first?.cell }))] };
  const { goals: together } = shrunk(shared as GridworldDocument, 3, 3).document;
  assert.equal(new Set(together.map(({ cell }) => String(cell))).size, 1);
});

test("names are their own, and the true goal follows its name", () => {
  assert.match(String(goals.renameGoal(eight, 0, "  ")), /needed/);
  assert.match(String(goals.renameGoal(eight, 0, "G2 ")), /taken/);
  assert.equal((goals.renameGoal(eight, 0, " Exit ") as GridworldDocument).true_goal, "Exit");
  assert.equal((goals.renameGoal(eight, 1, "Exit") as GridworldDocument).true_goal, "G1");
  const three = goals.removeGoal(eight, 0) as GridworldDocument;
  assert.equal(three.true_goal, "G2");
  const two = goals.removeGoal(three, 2) as GridworldDocument;
  assert.equal(two.true_goal, "G2");
  assert.match(String(goals.removeGoal(two, 0)), /At least two/);
  const more = goals.addGoal(eight) as GridworldDocument;
  assert.deepEqual(more.goals.at(-1), { name: "G5", cell: [7, 7] });
  assert.match(String(goals.addGoal(eight, [2, 1])), /wall/);
});

test("presets are known again, and staying gets a symbol", () => {
  assert.equal(sensor.presetOf(eight, "adversarial"), "enemy");
  assert.equal(sensor.presetOf(eight, "cooperative"), "friend");
  const own = sensor.setSymbol(eight, "adversarial", "north", "up") as GridworldDocument;
  assert.equal(sensor.presetOf(own, "adversarial"), null);
  assert.match(String(sensor.setSymbol(eight, "adversarial", "north", " ")), /needed/);
  const blind = sensor.usePreset(eight, "adversarial", "nothing");
  const staying = sensor.setStay(blind, true);
  assert.equal(staying.observers.adversarial.sensor.stay, "moved");
  assert.equal(staying.observers.cooperative.sensor.stay, "stay");
  assert.equal(sensor.presetOf(staying, "adversarial"), "nothing");
});

test("a quick hand skips no cell", () => {
  assert.deepEqual(between([0, 0], [3, 1]).map(String), ["1,0", "2,1", "3,1"]);
  assert.deepEqual(between([2, 2], [2, 2]), []);
});

test("a drag back to where it began is none", () => {
  const drag = draggedTo(draggedTo(carry(eight, { kind: "wall" }, [2, 1]), [2, 0]), [2, 1]);
  assert.equal(drag.document, eight);
  const off = draggedTo(draggedTo(carry(eight, { kind: "start" }, [0, 7]), [0, 6]), [0, 3]);
  assert.deepEqual([off.document.start, off.kind === "carry" && off.taken], [[0, 6], false]);
});

/** Any edit that the page can make. */
function anyEdit(document: GridworldDocument, dice: Dice): GridworldDocument | string {
  const { width, height } = document;
  const cell = (): Cell => [dice.below(width + 2) - 1, dice.below(height + 2) - 1];
  const inside = (): Cell => [dice.below(width), dice.below(height)];
  const role = dice.of(roles);
  const index = dice.below(document.goals.length);
  const edits: (() => GridworldDocument | string)[] = [
    () => {
      const smaller = resized(document, 2 + dice.below(8), 2 + dice.below(8));
      return typeof smaller === "string" ? smaller : smaller.document;
    },
    () => goals.addGoal(document),
    () => goals.addGoal(document, cell()),
    () => goals.removeGoal(document, index),
    () => goals.renameGoal(document, index, dice.of(["G1", "x", "", "__proto__", "\ud800", "a".repeat(300), "名"])),
    () => goals.chooseTrueGoal(document, index),
    () => sensor.setStay(document, dice.coin()),
    () => sensor.usePreset(document, role, dice.of(["enemy", "friend", "everything", "nothing"] as const)),
    () => sensor.setSymbol(document, role, dice.of(sensor.moves), dice.of(["a", "b", " ", "seen at 1,1"])),
    () =>
      dice.of([cells.believeEverywhere, cells.believeStart, cells.watchEverywhere, cells.watchNowhere])(document, role),
    ...Array.from({ length: 12 }, () => () => anyDrag(document, dice, inside, cell)),
  ];
  return dice.of(edits)();
}

function anyDrag(document: GridworldDocument, dice: Dice, inside: () => Cell, cell: () => Cell): GridworldDocument {
  const board = dice.of(["actor", ...roles] as const);
  const tool = dice.of(tools);
  const from = inside();
  const paint = paintOf(tool, board);
  const piece = pieceAt(document, board, from);
  let drag: Drag;
  if (paint !== null) drag = stroke(document, paint, from);
  else if (piece !== null) drag = carry(document, piece, from);
  else return document;
  for (let moves = dice.below(5); moves > 0; moves -= 1) drag = draggedTo(drag, cell());
  return drag.document as GridworldDocument;
}

test("the core takes whatever is made of a grid", () => {
  let made = 0;
  for (let seed = 0; seed < 60; seed += 1) {
    const dice = new Dice(seed);
    let document = dice.coin() ? eight : newGrid(2 + dice.below(5), 2 + dice.below(5));
    for (let count = 0; count < 60; count += 1) {
      const edited = anyEdit(document, dice);
      if (typeof edited === "string" || edited === document) continue;
      const before = JSON.stringify(document);
      assert.equal(taken(written(edited)), true, `seed ${seed}, edit ${count}: ${before}`);
      document = edited;
      made += 1;
    }
    assert.equal(everyCell(document).length, document.width * document.height);
  }
  assert(made > 1500, `only ${made} edits were made`);
});
