// The Rust core's types, as its bindings declare them. Everything the page knows of planning comes through these.
export type {
  Advice,
  DocumentError,
  LengthPoint,
  NextAction,
  Outcome,
  Place,
  Progress,
  Scene,
  SolveOptions,
  State,
  Trace,
  TraceStep,
} from "../pkg/mo_copp.js";
