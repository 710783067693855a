//! The types that TypeScript sees. They mirror [`report`](crate::report).

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** `[column, row]` in a grid, a name in an explicit problem, the facts that hold elsewhere. */
export type State = [number, number] | string | string[];
export type Role = "adversarial" | "cooperative";
export type SolverName = "exact" | "ip" | "search" | "baseline" | "obfuscate" | "legible";
export type EncodingName = "paper" | "belief-flow";
export type Status = "optimal" | "solved" | "feasible" | "infeasible" | "limit";
export interface ByObserver<T> { adversarial: T; cooperative: T }

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
  pareto?: boolean;
}

export interface Outcome {
  status: Status;
  solver: SolverName;
  encoding?: EncodingName;
  horizon: number | null;
  plan: string[] | null;
  goals: ByObserver<string[]> | null;
  goal_difference: number | null;
  pareto?: { adversarial: number; cooperative: number; plan: string[] }[];
  /** The limit that was met. */
  limit?: string;
  stats: {
    states: number; beliefs: number; seconds: number;
    expansions?: number; generated?: number; belief_size?: number;
    nodes?: number; iterations?: number; variables?: number; rows?: number;
  };
}

export interface TraceStep {
  action: string | null;
  state: State;
  symbols: ByObserver<string | null>;
  beliefs: ByObserver<State[]>;
  goals: ByObserver<string[]>;
  goal_difference: number;
}

export interface Trace { valid: boolean; steps: TraceStep[]; goal_difference: number }

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

interface SceneBase {
  goals: { name: string; cell?: [number, number]; condition?: string }[];
  true_goal: string;
  observers: { name: string; role: Role }[];
}
export interface GridworldScene extends SceneBase {
  format: "gridworld";
  width: number;
  height: number;
  walls: [number, number][];
  start: [number, number];
  goals: { name: string; cell: [number, number] }[];
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
  goals: { name: string; condition: string }[];
}
export type Scene = GridworldScene | DeliveryScene | ExplicitScene | PddlScene;
"#;

#[wasm_bindgen]
extern "C" {
    /// Options of a solver.
    #[wasm_bindgen(typescript_type = "SolveOptions")]
    pub type SolveOptionsJs;
    /// The answer of a solver.
    #[wasm_bindgen(typescript_type = "Outcome")]
    pub type OutcomeJs;
    /// How far a solver is.
    #[wasm_bindgen(typescript_type = "Progress")]
    pub type ProgressJs;
    /// A replayed plan.
    #[wasm_bindgen(typescript_type = "Trace")]
    pub type TraceJs;
    /// What there is to draw.
    #[wasm_bindgen(typescript_type = "Scene")]
    pub type SceneJs;
}
