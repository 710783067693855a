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

/** Every other format is edited as text alone. */
export interface OtherDocument {
  format: "explicit";
}

export type ProblemDocument = GridworldDocument | DeliveryDocument | OtherDocument;
