// Editing a board with a mouse, a pen or a finger.
import { inside } from "../problem/cells.js";
import { carry, type Drag, stroke } from "../problem/drag.js";
import type { BoardName } from "../view/observers.js";
import { begin, type DragStores, finish, goTo, takeBack } from "./dragging.js";
import { cellAt, grasped, pointIn } from "./reach.js";
import { editable, paintOf, type ToolStores, toolInHand } from "./tools.js";

export type PointerStores = ToolStores & DragStores;

export interface BoardPointer {
  down: (event: PointerEvent) => void;
  move: (event: PointerEvent) => void;
  up: (event: PointerEvent) => void;
  /** The browser took the pointer away: for scrolling, or since a window came up. */
  lost: (event: PointerEvent) => void;
  touch: (event: TouchEvent) => void;
}

/** A hand that presses a button shakes this much, in pixels. */
const SHAKE = 3;

/** The pointer that edits, only one at a time, and where it was pressed. */
let holding: { pointer: number; x: number; y: number; page: Document } | null = null;

function hold(held: NonNullable<typeof holding>): void {
  letGo();
  holding = held;
  held.page.addEventListener("dragstart", refuse, true);
}

function letGo(): void {
  holding?.page.removeEventListener("dragstart", refuse, true);
  holding = null;
}

/** A page may have cards that can be dragged: one stays in its place while something on its board is. */
function refuse(event: Event): void {
  event.preventDefault();
  event.stopPropagation();
}

export function boardPointer(board: BoardName, playground: PointerStores): BoardPointer {
  const { editing } = playground;
  return {
    down(event) {
      if (!event.isPrimary || event.button !== 0 || editing.drag.value !== null) return;
      const svg = event.currentTarget as SVGSVGElement;
      const drag = dragFrom(board, playground, svg, event, event.pointerType === "touch");
      const point = pointIn(svg, event);
      if (point !== null) editing.cursor.value = { board, cell: cellAt(point), shown: false };
      if (drag === null) return;
      hold({ pointer: event.pointerId, x: event.clientX, y: event.clientY, page: svg.ownerDocument });
      if (toolInHand(playground) === "belief") playground.timeline.goTo(0);
      begin(playground, drag);
      // A brush may leave the board at once; a piece that is only clicked goes on being what is clicked.
      if (drag.kind === "stroke") svg.setPointerCapture(event.pointerId);
    },
    move(event) {
      if (event.pointerId !== holding?.pointer) return;
      if (event.buttons === 0) {
        // It was let go where nobody heard of it.
        letGo();
        takeBack(playground);
        return;
      }
      const svg = event.currentTarget as SVGSVGElement;
      if (!svg.hasPointerCapture(event.pointerId)) {
        if (Math.hypot(event.clientX - holding.x, event.clientY - holding.y) <= SHAKE) return;
        svg.setPointerCapture(event.pointerId);
      }
      const point = pointIn(svg, event);
      const base = editing.drag.value?.base;
      if (point === null || base === undefined) return;
      const cell = cellAt(point);
      if (inside(base, cell)) goTo(playground, cell);
    },
    up(event) {
      if (event.pointerId !== holding?.pointer) return;
      letGo();
      const drag = editing.drag.value;
      finish(playground);
      // A goal that was pressed and not carried anywhere was chosen.
      if (drag?.kind === "carry" && drag.piece.kind === "goal" && drag.document === drag.base) {
        const goal = drag.base.goals[drag.piece.index];
        if (goal !== undefined && !(event.currentTarget as Element).hasPointerCapture(event.pointerId))
          playground.boards.story.choose(goal.name);
      }
    },
    lost(event) {
      if (event.pointerId !== holding?.pointer) return;
      // A finger is held by what it touched until the board takes hold of it.
      if (event.type === "lostpointercapture" && event.target !== event.currentTarget) return;
      letGo();
      takeBack(playground);
    },
    touch(event) {
      // What a tool takes hold of does not scroll; everything else does.
      const finger = event.touches[0];
      if (finger === undefined || event.touches.length > 1 || !event.cancelable) return;
      const svg = event.currentTarget as SVGSVGElement;
      if (editing.drag.value !== null || dragFrom(board, playground, svg, finger, true) !== null)
        event.preventDefault();
    },
  };
}

/** What a press there takes hold of; null where that is nothing. */
function dragFrom(
  board: BoardName,
  playground: PointerStores,
  svg: SVGSVGElement,
  at: { clientX: number; clientY: number },
  touch: boolean,
): Drag | null {
  const document = editable(playground);
  const point = pointIn(svg, at);
  if (document === null || point === null) return null;
  const tool = toolInHand(playground);
  if (tool === "move") {
    const grasp = grasped(document, board, point, touch);
    return grasp === null ? null : carry(document, grasp.piece, grasp.cell);
  }
  const paint = paintOf(tool, board);
  const cell = cellAt(point);
  return paint === null || !inside(document, cell) ? null : stroke(document, paint, cell);
}
