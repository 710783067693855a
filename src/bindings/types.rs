//! The types that TypeScript sees. They mirror [`report`](crate::report).

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** `[column, row]` in a gridworld, an object in the other formats with cells, a name in an explicit problem, the facts
 * that hold elsewhere. */
export type State = Cell | BoxState | RobotState | string | string[];
/** `[column, row]` */
export type Cell = [number, number];
/** A state of box pushing. */
export interface BoxState { robot: Cell; facing: "north" | "south" | "east" | "west"; box: Cell }
/** A state of the recycling robot. */
export interface RobotState { robot: Cell; battery: number; can: Cell | "held" }
export type Role = "adversarial" | "cooperative";
export type SolverName = "exact" | "ip" | "search" | "satisficing" | "baseline" | "obfuscate" | "legible";
export type EncodingName = "paper" | "belief-flow";
export type Status = "optimal" | "solved" | "feasible" | "infeasible" | "limit";
export interface ByObserver<T> { adversarial: T; cooperative: T }

/** A stretch of one line of a text. Lines and columns count from 1, in characters; the length is 0 where something is
 * missing. */
export interface Place { line: number; column: number; length: number }

/** What a document that is not right throws. */
export interface DocumentError extends Error {
  name: "DocumentError";
  /** Where it stands in the text of the document. */
  place: Place;
  /** The same as keys, `goals[1].cell`; not where the text is no JSON. */
  path?: string;
  /** Line and column in the PDDL text that stands at the path, where there is one; else of the whole text, where it is
   * no JSON. */
  line?: number;
  column?: number;
  found?: string;
  expected?: string;
}

/** A file of a goal-recognition problem. */
export interface ImportFile { name: string; text: string }
/** What the files of a goal-recognition problem leave open. Sensors are templates of symbols, `{name}` and `{name} {1}`
 * when left out; the true goal is a number in `hyps.dat`, from 1, in place of `real_hyp.dat`. */
export interface ImportOptions {
  adversarial_sensor?: string;
  cooperative_sensor?: string;
  /** Objects that look alike, by the name under which the observer sees them. */
  adversarial_groups?: Record<string, string[]>;
  cooperative_groups?: Record<string, string[]>;
  true_goal?: number;
}
/** A document as JSON text, the actions of `obs.dat` (a plan or some of one), and what was left out. */
export interface Imported { document: string; observations: string[] | null; notes: string[] }
/** What files that cannot be imported throw. */
export interface ImportError extends Error { name: "ImportError"; file?: string; line?: number; column?: number }

export interface SolveOptions {
  solver: SolverName;
  encoding?: EncodingName;
  /** A number of actions, or any number of them. */
  horizon?: number | "any";
  /** By how much the horizon is raised while it has no plan. */
  horizon_step?: number;
  horizon_limit?: number;
  /** At least k goals survive for the enemy. */
  k?: number;
  /** At most j goals survive for the friend. */
  j?: number;
  require?: { observer: string; goal: string }[];
  forbid?: { observer: string; goal: string }[];
  /** Every reachable pair of survivor counts, for `exact`. */
  pairs?: boolean;
  /** The old name of `pairs`: the outcome has the pairs under this name too. */
  pareto?: boolean;
  /** The best plan of every length from 0 to this one (at most 1000), for `exact` and without a horizon.
      The plan of the outcome is then the best that has at most so many actions. */
  lengths?: number;
  /** The most that a plan may cost (a whole number up to 4294967295): the cost where the problem's PDDL has costs, the number of
      actions elsewhere. */
  cost_limit?: number;
}

export interface Outcome {
  status: Status;
  solver: SolverName;
  encoding?: EncodingName;
  horizon: number | null;
  plan: string[] | null;
  /** What the plan costs, where the problem has costs. */
  cost?: number;
  /** The most that a plan may cost, where that was asked for. */
  cost_limit?: number;
  goals: ByObserver<string[]> | null;
  goal_difference: number | null;
  /** The goals of which it is not known whether they are possible, where beliefs are too large to be worked out: they are among the friend's and not among the enemy's. */
  unsettled?: ByObserver<string[]>;
  /** Of `exact` and `ip`: no plan can be better than `bound`, and the plan found is at most `gap` worse. */
  bound?: number;
  gap?: number;
  /** Of `exact` over all lengths: whether the plan is proved to be a shortest one of its goal difference. */
  length_proved?: boolean;
  /** With `pairs`: sorted. */
  pairs?: { adversarial: number; cooperative: number; plan: string[] }[];
  /** There, and false, where a limit or a stop came before all pairs were found: `pairs` has those found until then.
      The status may be `optimal` all the same. */
  pairs_complete?: false;
  /** With `pairs`: the Pareto front of them, those for which no other is at least as good for both sides. */
  front?: { adversarial: number; cooperative: number }[];
  /** With `pareto`: the pairs, sorted. */
  pareto?: { adversarial: number; cooperative: number; plan: string[] }[];
  /** The same of `pareto` as `pairs_complete`. */
  pareto_complete?: false;
  /** One for each length from 0, where `lengths` was asked for; of a run that was stopped, only for the
      lengths that are proved. Null where no plan of that length keeps the bounds. */
  lengths?: LengthPoint[];
  /** The limit that was met. */
  limit?: string;
  stats: {
    states: number; beliefs: number; seconds: number;
    expansions?: number; generated?: number; belief_size?: number; walks?: number; walks_found?: number; settled_by_pairs?: number; settled_by_beliefs?: number;
    nodes?: number; iterations?: number; variables?: number; rows?: number;
  };
}

export type LengthPoint =
  | { length: number; adversarial: number; cooperative: number; goal_difference: number; plan: string[] }
  | { length: number; adversarial: null; cooperative: null; goal_difference: null; plan: null };

/** Why a run found no plan, and which change of a single option would allow one. */
export interface Advice {
  /** The true goal cannot be reached; no plan has exactly so many actions; no such plan keeps the bounds.
      Null where there is a plan after all, or where the work stopped before that was known. */
  reason: "unreachable" | "length" | "bounds" | null;
  /** The length of a shortest plan for the true goal, whatever anybody believes. */
  shortest: number | null;
  /** The smallest change first; each with the best plan that it allows. */
  remedies: Remedy[];
  /** Whether these are all and nothing nearer would do: no limit or stop came before the proof. */
  complete: boolean;
}
export interface Remedy {
  change: "horizon" | "k" | "j";
  value: number;
  goal_difference: number;
  plan: string[];
}

export interface TraceStep {
  action: string | null;
  state: State;
  symbols: ByObserver<string | null>;
  beliefs: ByObserver<State[]>;
  /** What the states of each belief have in common, where an overview does not give all of them. */
  summaries?: ByObserver<BeliefSummary>;
  goals: ByObserver<string[]>;
  /** In an overview: the goals that are ruled out for each observer. No continuation makes them possible again, as far
   * as a relaxation tells: what may still come is never among them. At the end of a plan for the true goal it is all
   * that are not possible. */
  ruled_out?: ByObserver<string[]>;
  goal_difference: number;
}

/** How far a goal is from what an observer believes: the believed state from which the fewest actions lead there; both are
 * null where none do. */
export interface Nearest {
  state: State | null;
  actions: number | null;
}
/** Why a goal is not possible for an observer: the last believed states that were one action away from it or in it, and
 * the symbol that ended them. */
export interface Elimination {
  /** The step at whose symbol they went. */
  step: number;
  symbol: string;
  /** Believed before: an action would have led to the goal, with another symbol. At most 100, of `led_count`. */
  led: { state: State; action: string; result: State; symbol: string }[];
  led_count: number;
  /** Believed before: the goal held there. At most 100, of `held_count`. */
  held: State[];
  held_count: number;
}

export interface Trace { valid: boolean; cost?: number; steps: TraceStep[]; goal_difference: number }

/** A belief in numbers: what may hold, the most telling first, and in how many states each candidate goal holds. */
export interface BeliefSummary {
  states: number;
  shares: Share[];
  /** How many more facts there are. */
  left_out: number;
  goals: number[];
}
/** In how many states a fact holds, or a part of the state has a value. */
export type Share = { states: number } & ({ fact: string } | { part: string; value: Cell | number | string });

/** An action that can be taken after a plan, the resulting state, and whether the true goal holds there. */
export interface NextAction { action: string; state: State; goal: boolean }

export interface Progress {
  solver: SolverName;
  unit: "expansions" | "nodes";
  done: number;
  horizon: number | null;
  goal_difference: number | null;
  bound: number | null;
  gap: number | null;
  plan: string[] | null;
}

/** What a picture shows; with nothing said all boards of the last step of the plan, light, with captions. */
export interface PictureOptions {
  /** From 0, the start. */
  step?: number;
  /** All steps, one after another, without end, each shown for so many `milliseconds` (100 to 60,000; else 1000). */
  animate?: boolean;
  milliseconds?: number;
  board?: "all" | "actor" | Role;
  /** Whether headings, goals and the line about the step are there. */
  captions?: boolean;
  /** Whether the true goal is marked as such. */
  true_goal?: boolean;
  /** Whether the agent stops where the plan ends; else it may go on, and nothing is ruled out. */
  ended?: boolean;
  /** Whether boards of cells have the numbers of columns and rows at their edges. */
  numbers?: boolean;
  theme?: "light" | "dark";
}

export type ExerciseKind = "possible-goals" | "belief" | "walk" | "best" | "placement" | "guess";
/** The question of a seed of an exercise. An answer is made of positions in `form.choices`. */
export interface Question {
  kind: ExerciseKind;
  title?: string;
  introduction?: string;
  question: string;
  seed: number;
  /** Whether other seeds have other questions. */
  varies: boolean;
  form: { arity: "one" | "set" | "sequence"; choice: "goal" | "state" | "action" | "cell"; choices: State[] };
  observer?: Role;
  /** The walk that the question tells. */
  plan?: string[];
  place?: "camera" | "wall" | "start";
  hints: string[];
  attempts?: number;
  hide: "beliefs"[];
  /** Whether all of the problem stays as it is, or which keys of its document. */
  lock: boolean | string[];
  /** The document of the problem, without the exercise; of a `guess` without a solution `true_goal` is the first candidate, whichever it is. */
  document: object;
  /** Only where it was asked for. `remarks`: what makes the question trivial. */
  solution?: { answer: unknown; size: number; steps: number; remarks: string[] };
}
/** What a few seeds of an exercise come to. */
export interface VariantSample {
  /** How many seeds were drawn: 20, or fewer where drawing takes long. */
  seeds: number;
  /** How many of them have a variant. */
  found: number;
  /** How many different questions those ask. */
  different: number;
  /** How many different answers were found to them. */
  answers: number;
  /** What an author should know before the exercise is handed out: "all 20 variants drawn have the same answer". */
  remarks: string[];
}
/** A walk that contradicts an answer. */
export interface Counterexample {
  observer: Role;
  start: State;
  actions: string[];
  symbols: string[];
  end: State;
  /** The first step, from 1, whose symbol is another than the observer was told. */
  differs?: number;
}
export interface ExerciseVerdict {
  right: boolean;
  score: 0 | 1;
  /** What is wrong, the first thing first. */
  findings: { text: string; counterexample?: Counterexample }[];
  /** The answer code. */
  code: string;
}

interface SceneBase {
  goals: { name: string; cell?: Cell; condition?: string; facts?: string[] }[];
  true_goal: string;
  observers: { name: string; role: Role }[];
}
interface GridScene extends SceneBase {
  width: number;
  height: number;
  walls: Cell[];
  goals: { name: string; cell: Cell }[];
}
export interface GridworldScene extends GridScene { format: "gridworld"; start: Cell }
/** A goal's cell is where the box must be. */
export interface BoxPushingScene extends GridScene { format: "box-pushing"; start: BoxState }
/** A goal's cell is where the can must lie: a bin. Battery levels go from 0 to one less than there are. */
export interface RecyclingRobotScene extends GridScene {
  format: "recycling-robot";
  charger: Cell;
  battery_levels: number;
  start: RobotState;
}
export interface DeliveryScene extends SceneBase {
  format: "delivery";
  factories: { name: string; packages: string[] }[];
  deliver: number;
}
export interface ExplicitScene extends SceneBase { format: "explicit" }
/** Atoms are texts, `(on a b)`, here and in states. */
export interface PddlScene extends SceneBase {
  format: "pddl";
  domain: string;
  /** Each with all types that it is of, `object` among them. */
  objects: { name: string; types: string[] }[];
  /** The atoms of a predicate that no action `changes` stand in `initial` alone. */
  predicates: { name: string; arguments: number; changes: boolean }[];
  initial: string[];
  /** `facts`: what the condition asks for that actions change; the rest of it always holds, or is a negation. */
  goals: { name: string; condition: string; facts: string[] }[];
}
export type Scene =
  GridworldScene | BoxPushingScene | RecyclingRobotScene | DeliveryScene | ExplicitScene | PddlScene;
"#;

#[cfg(feature = "full")]
#[wasm_bindgen]
extern "C" {
    /// Why there is no plan, and what would do.
    #[wasm_bindgen(typescript_type = "Advice")]
    pub type AdviceJs;
    /// Files to import.
    #[wasm_bindgen(typescript_type = "ImportFile[]")]
    pub type ImportFilesJs;
    /// Options of an import.
    #[wasm_bindgen(typescript_type = "ImportOptions")]
    pub type ImportOptionsJs;
    /// A document made of files.
    #[wasm_bindgen(typescript_type = "Imported")]
    pub type ImportedJs;
    /// The question of an exercise.
    #[wasm_bindgen(typescript_type = "Question")]
    pub type QuestionJs;
    /// What a few seeds of an exercise come to.
    #[wasm_bindgen(typescript_type = "VariantSample | null")]
    pub type VariantSampleJs;
    /// What is said of an answer.
    #[wasm_bindgen(typescript_type = "ExerciseVerdict")]
    pub type VerdictJs;
}

#[wasm_bindgen]
extern "C" {
    /// Options of a solver.
    #[wasm_bindgen(typescript_type = "SolveOptions")]
    pub type SolveOptionsJs;
    /// Options of a picture.
    #[wasm_bindgen(typescript_type = "PictureOptions")]
    pub type PictureOptionsJs;
    /// The answer of a solver.
    #[wasm_bindgen(typescript_type = "Outcome")]
    pub type OutcomeJs;
    /// How far a solver is.
    #[wasm_bindgen(typescript_type = "Progress")]
    pub type ProgressJs;
    /// A replayed plan.
    #[wasm_bindgen(typescript_type = "Trace")]
    pub type TraceJs;
    /// Why a goal is not possible, where a state was near it.
    #[wasm_bindgen(typescript_type = "Elimination | null")]
    pub type EliminationJs;
    /// How far a goal is from what an observer believes.
    #[wasm_bindgen(typescript_type = "Nearest | null")]
    pub type NearestJs;
    /// What can be done after a plan.
    #[wasm_bindgen(typescript_type = "NextAction[]")]
    pub type NextActionsJs;
    /// What there is to draw.
    #[wasm_bindgen(typescript_type = "Scene")]
    pub type SceneJs;
}
