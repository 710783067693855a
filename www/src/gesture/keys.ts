// Editing a board with the keyboard: the arrow keys move a cursor, and what stands under it is changed in place.
import { inside } from "../problem/cells.js";
import { carry, isPainted, type Paint, stroke } from "../problem/drag.js";
import { isWall, setBelieved, setCamera, setWall } from "../problem/grid-cells.js";
import { addGoal, goalAt, removeGoal } from "../problem/grid-goals.js";
import type { Cell, FloorDocument } from "../problem/types.js";
import type { BoardName } from "../view/observers.js";
import { begin, type DragStores, finish, goTo, takeBack } from "./dragging.js";
import { carriedInWords, cellInWords, pieceName } from "./spoken.js";
import { editable, paintOf, pieceAt, roleOf, type ToolStores, toolInHand } from "./tools.js";

export type KeyStores = ToolStores & DragStores;

const steps: Record<string, Cell> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** What every key is for, as the page's help lists it. */
export const boardKeys: readonly [keys: string, meaning: string][] = [
  ["Arrow keys", "move the cursor on a board"],
  ["Enter or Space", "pick up and put down, or paint"],
  ["Escape", "put back"],
  ["W", "wall"],
  ["G", "new goal"],
  ["B", "first belief"],
  ["C", "camera"],
  ["Delete", "remove a goal or a wall"],
];

interface Here {
  playground: KeyStores;
  board: BoardName;
  document: FloorDocument;
  cell: Cell;
}

export function boardKey(board: BoardName, playground: KeyStores) {
  return (event: KeyboardEvent): void => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const document = editable(playground);
    if (document === null) return;
    const here = { playground, board, document, cell: cursorOn(board, playground, document) };
    const step = steps[event.key];
    const action = step === undefined ? actions[event.key.toLowerCase()] : (from: Here) => move(from, step);
    if (action === undefined) return;
    event.preventDefault();
    // Other keys of the page are not meant.
    event.stopPropagation();
    playground.editing.cursor.value = { board, cell: here.cell, shown: true };
    say(playground, action(here));
  };
}

/** The cursor shows itself to who comes with the keyboard. */
export function boardFocus(board: BoardName, playground: KeyStores) {
  return (event: FocusEvent): void => {
    const document = editable(playground);
    if (document === null || !(event.currentTarget as Element).matches(":focus-visible")) return;
    const cell = cursorOn(board, playground, document);
    playground.editing.cursor.value = { board, cell, shown: true };
    say(playground, cellInWords(document, board, cell));
  };
}

/** What is carried by the keyboard goes back when the keyboard goes elsewhere. */
export function boardBlur(playground: KeyStores) {
  return (): void => {
    const { cursor } = playground.editing;
    if (cursor.value?.shown !== true) return;
    takeBack(playground);
    cursor.value = { ...cursor.value, shown: false };
    say(playground, "");
  };
}

/** Where it was last; at first the start. */
function cursorOn(board: BoardName, { editing }: KeyStores, document: FloorDocument): Cell {
  const cursor = editing.cursor.value;
  return cursor !== null && cursor.board === board && inside(document, cursor.cell) ? cursor.cell : startOf(document);
}

const startOf = (document: FloorDocument): Cell =>
  document.format === "gridworld" ? document.start : document.start.robot;

const say = (playground: KeyStores, words: string): void => {
  playground.editing.said.value = words;
};

/** Every action answers with the words that tell what came of it. */
type Action = (here: Here) => string;

function move({ playground, board, document, cell }: Here, [right, down]: Cell): string {
  const target: Cell = [cell[0] + right, cell[1] + down];
  const next = inside(document, target) ? target : cell;
  playground.editing.cursor.value = { board, cell: next, shown: true };
  goTo(playground, next);
  const drag = playground.editing.drag.value;
  return drag === null ? cellInWords(document, board, next) : carriedInWords(drag, document, board);
}

const actions: Record<string, Action> = {
  enter: use,
  " ": use,
  w: (here) => toggle(here, { kind: "wall" }, setWall),
  b: (here) => forObserver(here, "belief"),
  c: (here) => forObserver(here, "camera"),
  g: (here) => make(here, addGoal(here.document, here.cell)),
  delete: remove,
  backspace: remove,
};

/** Picks up or puts down; with a brush, paints one cell. */
function use({ playground, board, document, cell }: Here): string {
  const { drag } = playground.editing;
  const tool = toolInHand(playground);
  if (drag.value !== null) {
    const refused = drag.value.kind === "carry" && !drag.value.taken;
    finish(playground);
    return refused ? "put down where it could stand last." : "put down.";
  }
  if (tool === "move") {
    const piece = pieceAt(document, board, cell);
    if (piece === null) return "there is nothing to pick up here.";
    const carried = carry(document, piece, cell);
    begin(playground, carried);
    return `${pieceName(carried)} picked up: the arrow keys carry it, Enter puts it down, Escape puts it back.`;
  }
  const paint = paintOf(tool, board);
  if (paint === null) return notHere;
  if (tool === "belief") playground.timeline.goTo(0);
  const painted = stroke(document, paint, cell);
  begin(playground, painted);
  finish(playground);
  return cellInWords(painted.document, board, cell);
}

const notHere = "that is for the enemy’s and the friend’s board.";

function forObserver(here: Here, kind: "belief" | "camera"): string {
  const role = roleOf(here.board);
  if (role === null) return notHere;
  const { document } = here;
  if (document.format !== "gridworld") return "what is believed of a robot at first is edited as text.";
  if (kind === "belief") here.playground.timeline.goTo(0);
  const set = kind === "belief" ? setBelieved : setCamera;
  return make(here, set(document, role, here.cell, !isPainted(document, { kind, role }, here.cell)));
}

function toggle(
  here: Here,
  paint: Paint,
  set: (document: FloorDocument, cell: Cell, on: boolean) => FloorDocument,
): string {
  return make(here, set(here.document, here.cell, !isPainted(here.document, paint, here.cell)));
}

function remove(here: Here): string {
  const { document, cell } = here;
  const index = goalAt(document, cell);
  if (index >= 0) return make(here, removeGoal(document, index));
  return isWall(document, cell) ? make(here, setWall(document, cell, false)) : "there is nothing to remove here.";
}

/** Makes an edit, or says why not. */
function make({ playground, board, document, cell }: Here, edited: FloorDocument | string): string {
  if (playground.editing.drag.value !== null) return "put down first what you carry.";
  if (typeof edited === "string") return edited;
  if (edited === document) return `that can’t be here. ${cellInWords(document, board, cell)}`;
  const refused = playground.edits.forbids(edited);
  if (refused !== null) return refused;
  playground.edits.apply(edited);
  return cellInWords(edited, board, cell);
}
