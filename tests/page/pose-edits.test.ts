// Editing box pushing and the recycling robot on the boards: by mouse, by keyboard, and whatever is made of them the core
// takes.
import assert from "node:assert/strict";
import { test } from "node:test";
import { pieceAt } from "../../www/src/gesture/tools.js";
import { everyCell } from "../../www/src/problem/cells.js";
import { carry, draggedTo, stroke } from "../../www/src/problem/drag.js";
import { setWall } from "../../www/src/problem/grid-cells.js";
import { addGoal, removeGoal } from "../../www/src/problem/grid-goals.js";
import { moveThing } from "../../www/src/problem/pose-cells.js";
import type { BoxPushingDocument, PoseDocument, RecyclingRobotDocument } from "../../www/src/problem/types.js";
import { taken } from "./support/core.js";
import { Dice } from "./support/dice.js";
import { documentOf } from "./support/gallery.js";
import { dragMouse, documentOf as edited, tool } from "./support/hands.js";
import { openTab, statusIs } from "./support/playground.js";
import { board, open } from "./support/views.js";

const box = JSON.parse(documentOf("box-pushing")) as BoxPushingDocument;
const robot = JSON.parse(documentOf("recycling-robot")) as RecyclingRobotDocument;

test("a box that is moved is moved in what observers believe, and never into the robot", () => {
  const moved = moveThing(box, "box", [2, 2]) as BoxPushingDocument;
  assert.deepEqual(moved.start, { robot: [0, 3], facing: "east", box: [2, 2] });
  for (const { initial_belief = [] } of Object.values(moved.observers)) {
    assert.equal(initial_belief.length, 4);
    assert(initial_belief.every((pose) => String(pose.box) === "2,2"));
  }
  assert.equal(moveThing(box, "box", [0, 3]), box);
  assert.equal(moveThing(box, "robot", [1, 2]), box);
  assert.equal(moveThing(box, "robot", [0, 4]), box);
});

test("a wall takes what was believed in its cell, but neither the start nor a goal", () => {
  const walled = setWall(robot, [1, 0], true) as RecyclingRobotDocument;
  assert.deepEqual(walled.walls, [[1, 0]]);
  const cells = (document: RecyclingRobotDocument) =>
    (document.observers.adversarial.initial_belief ?? []).map((pose) => String(pose.robot));
  assert(cells(robot).includes("1,0"));
  assert.deepEqual(
    cells(walled),
    cells(robot).filter((cell) => cell !== "1,0"),
  );
  for (const cell of [robot.start.robot, robot.charger, robot.goals[0]?.cell ?? assert.fail()]) {
    assert.equal(setWall(robot, cell, true), robot);
  }
});

test("the core takes whatever is made of them", () => {
  for (const [seed, first] of [box, robot, box, robot].entries()) {
    const dice = new Dice(seed);
    let document: PoseDocument = first;
    const places = everyCell(document);
    for (let edits = 0; edits < 60; edits += 1) {
      document = anyEdit(document, dice, () => dice.of(places));
      assert.equal(taken(JSON.stringify(document)), true, JSON.stringify(document));
    }
    assert.notDeepEqual(document, first);
  }
});

function anyEdit(document: PoseDocument, dice: Dice, cell: () => [number, number]): PoseDocument {
  const kind = dice.below(6);
  if (kind === 0) return wanted(addGoal(document, cell()), document);
  if (kind === 1) return wanted(removeGoal(document, dice.below(document.goals.length)), document);
  const from = cell();
  const piece = pieceAt(document, "actor", from);
  let drag = kind === 2 || piece === null ? stroke(document, { kind: "wall" }, from) : carry(document, piece, from);
  for (let moves = dice.below(4); moves > 0; moves -= 1) {
    const next = draggedTo(drag, cell());
    drag = next as typeof drag;
  }
  return drag.document as PoseDocument;
}

const wanted = (after: PoseDocument | string, before: PoseDocument) => (typeof after === "string" ? before : after);

const remember = `
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message) {
    if (message.kind === "solve") window.lastDocument = message.document;
    post.call(this, message);
  };
`;
const before = { before: (page: import("playwright-core").Page) => page.addInitScript(remember) };

test("the mouse drags box, robot, goal and walls, and the best plan follows", () =>
  open(
    "box-pushing",
    async (page) => {
      await page.getByRole("button", { name: "First step" }).click();
      await dragMouse(page, "actor", [
        [1, 2],
        [2, 2],
      ]);
      assert.deepEqual((await edited<BoxPushingDocument>(page)).start.box, [2, 2]);
      await board(page, "actor").locator('[data-box="2,2"]').waitFor();
      await dragMouse(page, "actor", [
        [3, 0],
        [3, 1],
      ]);
      assert.deepEqual((await edited<BoxPushingDocument>(page)).goals[2]?.cell, [3, 1]);
      await tool(page, "Walls");
      await dragMouse(page, "actor", [
        [0, 0],
        [0, 1],
      ]);
      assert.deepEqual((await edited<BoxPushingDocument>(page)).walls, [
        [0, 0],
        [0, 1],
      ]);
      for (let edits = 0; edits < 3; edits += 1) await page.keyboard.press("Control+z");
      await statusIs(page, "optimal");
      await page.locator(".problem-bar .title", { hasText: "Pushing a box" }).waitFor();
    },
    before,
  ));

test("the keyboard carries the can, and the tab names the goals", () =>
  open(
    "recycling-robot",
    async (page) => {
      await page.getByRole("button", { name: "First step" }).click();
      await board(page, "actor").focus();
      // From the robot at column 3, row 0 to the can at column 2, row 3, and one up with it.
      for (const key of [
        "ArrowLeft",
        "ArrowDown",
        "ArrowDown",
        "ArrowDown",
        "Enter",
        "ArrowUp",
        "ArrowLeft",
        "Enter",
      ]) {
        await page.keyboard.press(key);
      }
      assert.deepEqual((await edited<RecyclingRobotDocument>(page)).start.can, [1, 2]);
      await openTab(page, "Edit");
      const name = page.getByLabel("Name of goal 1");
      await name.fill("glass");
      await name.press("Enter");
      assert.equal((await edited<RecyclingRobotDocument>(page)).goals[0]?.name, "glass");
      await page.getByRole("button", { name: "Edit the rest as text" }).click();
      await page.locator('[role="tab"][data-tab="document"][aria-selected="true"]').waitFor();
    },
    before,
  ));
