// How many states an observer holds possible: a trace does not list all of a large belief.
import type { TraceStep } from "../core.js";
import type { Role } from "../view/observers.js";

export const stateCount = ({ summaries, beliefs }: TraceStep, role: Role): number =>
  summaries?.[role].states ?? beliefs[role].length;
