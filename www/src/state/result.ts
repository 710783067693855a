// What the page holds of a problem and of what a solver made of it.
import type { Outcome, SolveOptions } from "../core.js";
import type { ProblemDocument } from "../problem/types.js";
import type { Answered } from "../worker/protocol.js";

export type Status = "idle" | "solving" | "error" | Outcome["status"];

/** Whose steps are shown: a plan's, or those of the person who walks, or those that the person sees as the enemy. */
export type Mode = "plan" | "walk" | "guess";

export interface OpenDocument {
  text: string;
  value: ProblemDocument;
}

/** What a solve was asked and answered. */
export interface Result {
  options: SolveOptions;
  outcome: Answered;
}
