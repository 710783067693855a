// The Rust core's types, as the page uses them. Everything the page knows of planning comes through these.
import type { TraceStep as PlainStep, Trace as PlainTrace, State } from "../pkg/mo_copp.js";

export type {
  Advice,
  BeliefSummary,
  BoxState,
  ByObserver,
  Counterexample,
  DocumentError,
  ExerciseVerdict,
  LengthPoint,
  NextAction,
  Outcome,
  PictureOptions,
  Place,
  Progress,
  Question,
  RobotState,
  Scene,
  Share,
  SolveOptions,
  State,
} from "../pkg/mo_copp.js";

/** A step of an overview, which says as well which goals are ruled out for each observer: those that no continuation makes
 * possible again, and at the end of a plan for the true goal all that are not possible. */
export interface TraceStep extends PlainStep {
  ruled_out?: Record<"adversarial" | "cooperative", string[]>;
}

export interface Trace extends PlainTrace {
  steps: TraceStep[];
}

/** One for each observer; how far the goal is where it was never so near; null where that is not known. */
export type Eliminations = Record<"adversarial" | "cooperative", Elimination | Nearest | null>;

/** How far a goal is from what an observer believes: the believed state from which the fewest actions lead there; both are
 * null where none do. */
export interface Nearest {
  state: State | null;
  actions: number | null;
}

/** Why a goal is not possible for an observer: the last believed states that were one action away from it or in it, and
 * the symbol that ended them. Lists are cut at a hundred; the counts are not. */
export interface Elimination {
  /** The step at whose symbol they went. */
  step: number;
  symbol: string;
  led: { state: State; action: string; result: State; symbol: string }[];
  led_count: number;
  held: State[];
  held_count: number;
}
