// Edits of the floor on which a robot moves a box or a can: where things stand, and walls. As in `grid-cells.ts`, what
// can't be done leaves the document as it is.
import { inside, sameCell, without } from "./cells.js";
import type {
  BoxPose,
  BoxPushingDocument,
  Cell,
  PoseDocument,
  RecyclingRobotDocument,
  RobotPose,
  Role,
} from "./types.js";

export type Thing = "robot" | "box" | "can" | "charger";

const roles: readonly Role[] = ["adversarial", "cooperative"];

const free = (document: PoseDocument, cell: Cell): boolean =>
  inside(document, cell) && !(document.walls ?? []).some((wall) => sameCell(wall, cell));

/** What can be carried, with its cell; what is drawn on top comes last. */
export function things(document: PoseDocument): [Thing, Cell][] {
  if (document.format === "box-pushing") {
    return [
      ["box", document.start.box],
      ["robot", document.start.robot],
    ];
  }
  const { can, robot } = document.start;
  return [["charger", document.charger], ["robot", robot], ...(can === "held" ? [] : [["can", can] as [Thing, Cell]])];
}

export const poseTaken = (document: PoseDocument, cell: Cell): boolean =>
  [...things(document).map(([, place]) => place), ...document.goals.map((goal) => goal.cell)].some((place) =>
    sameCell(place, cell),
  );

/** Moves a thing of the start; what observers believed of it where it was, they believe of where it is. */
export function moveThing(document: PoseDocument, thing: Thing, to: Cell): PoseDocument {
  if (!free(document, to)) return document;
  if (document.format === "box-pushing") {
    const { robot, box } = document.start;
    if (sameCell(thing === "box" ? robot : box, to)) return document;
    return thing === "box" || thing === "robot" ? movedBox(document, thing, to) : document;
  }
  if (thing === "charger") return { ...document, charger: to };
  return thing === "robot" || thing === "can" ? movedRobot(document, thing, to) : document;
}

function movedBox(document: BoxPushingDocument, part: "robot" | "box", to: Cell): BoxPushingDocument {
  const start = { ...document.start, [part]: to };
  const follow = (pose: BoxPose): BoxPose =>
    sameCell(pose[part], document.start[part]) ? { ...pose, [part]: to } : pose;
  return withBeliefs({ ...document, start }, (poses) =>
    poses.map(follow).filter(({ robot, box }) => !sameCell(robot, box)),
  );
}

function movedRobot(document: RecyclingRobotDocument, part: "robot" | "can", to: Cell): RecyclingRobotDocument {
  const start = { ...document.start, [part]: to };
  const follow = (pose: RobotPose): RobotPose =>
    String(pose[part]) === String(document.start[part]) ? { ...pose, [part]: to } : pose;
  return withBeliefs({ ...document, start }, (poses) => poses.map(follow));
}

/** A wall takes with it what observers held possible in its cell. */
export function setPoseWall(document: PoseDocument, cell: Cell, wall: boolean): PoseDocument {
  if (!inside(document, cell) || free(document, cell) !== wall) return document;
  const walls = document.walls ?? [];
  if (!wall) return { ...document, walls: without(walls, cell) };
  if (poseTaken(document, cell)) return document;
  const walled = { ...document, walls: [...walls, cell] };
  return walled.format === "box-pushing"
    ? withBeliefs(walled, (poses) => poses.filter(({ robot, box }) => !sameCell(robot, cell) && !sameCell(box, cell)))
    : withBeliefs(walled, (poses) =>
        poses.filter(({ robot, can }) => !sameCell(robot, cell) && (can === "held" || !sameCell(can, cell))),
      );
}

/** Changes what is listed as believed at first. The start stays among it, and nothing is there twice. */
function withBeliefs<D extends PoseDocument>(document: D, change: (poses: D["start"][]) => D["start"][]): D {
  const start = document.start as D["start"];
  const key = (pose: D["start"]) => JSON.stringify(Object.entries(pose).sort(([a], [b]) => (a < b ? -1 : 1)));
  const observers = { ...document.observers };
  for (const role of roles) {
    const { initial_belief: poses, ...rest } = observers[role];
    if (poses === undefined) continue;
    const changed = new Map(change(poses as D["start"][]).map((pose) => [key(pose), pose]));
    changed.set(key(start), start);
    observers[role] = { initial_belief: [...changed.values()], ...rest } as (typeof observers)[Role];
  }
  return { ...document, observers };
}
