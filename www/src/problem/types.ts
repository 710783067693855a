// Problem documents as the page edits them. The core alone says whether one is right; these are the shapes that a
// document has once the core has taken it (docs/documents.md).
export type Cell = [column: number, row: number];
export type Role = "adversarial" | "cooperative";
export type Move = "north" | "south" | "east" | "west" | "stay";

export interface GridObserver {
  /** The start alone when left out. */
  initial_belief?: Cell[];
  cameras?: Cell[];
  sensor: { [move in Move]?: string };
}

export interface GridGoal {
  name: string;
  cell: Cell;
}

export interface GridworldDocument {
  format: "gridworld";
  width: number;
  height: number;
  walls?: Cell[];
  start: Cell;
  goals: GridGoal[];
  true_goal: string;
  stay?: boolean;
  observers: Record<Role, GridObserver>;
}

export interface DeliveryObserver {
  sensor: { load: string | Record<string, string>; deliver: string };
}

export interface DeliveryDocument {
  format: "delivery";
  factories: { name: string; packages: string[] }[];
  deliver: number;
  true_goal: string;
  observers: Record<Role, DeliveryObserver>;
}

export interface BoxPose {
  robot: Cell;
  facing: "north" | "south" | "east" | "west";
  box: Cell;
}

export interface RobotPose {
  robot: Cell;
  battery: number;
  can: Cell | "held";
}

export interface PoseObserver<Pose> {
  /** The start alone when left out. */
  initial_belief?: Pose[];
  sensor: Record<string, string>;
}

interface OnFloor<Pose> {
  width: number;
  height: number;
  walls?: Cell[];
  start: Pose;
  goals: GridGoal[];
  true_goal: string;
  observers: Record<Role, PoseObserver<Pose>>;
}

export interface BoxPushingDocument extends OnFloor<BoxPose> {
  format: "box-pushing";
}

export interface RecyclingRobotDocument extends OnFloor<RobotPose> {
  format: "recycling-robot";
  charger: Cell;
  battery_levels: number;
}

/** A robot on a floor, and something that it moves. */
export type PoseDocument = BoxPushingDocument | RecyclingRobotDocument;

/** The documents that are edited on the boards. */
export type FloorDocument = GridworldDocument | PoseDocument;

/** A domain and a problem in PDDL, each one text or the list of its lines. */
export interface PddlDocument {
  format: "pddl";
  domain: string | string[];
  problem: string | string[];
}

/** Every other format is edited as text alone. */
export interface OtherDocument {
  format: "explicit";
}

export type ProblemDocument =
  | GridworldDocument
  | DeliveryDocument
  | BoxPushingDocument
  | RecyclingRobotDocument
  | PddlDocument
  | OtherDocument;
