// The Rust core's types, as its bindings declare them. Everything the page knows of planning comes through these.
export type {
  Advice,
  BeliefSummary,
  BoxState,
  DocumentError,
  LengthPoint,
  NextAction,
  Outcome,
  Place,
  Progress,
  RobotState,
  Scene,
  Share,
  SolveOptions,
  State,
  Trace,
  TraceStep,
} from "../pkg/mo_copp.js";
