// What the page and its worker say to each other.
//
// Each request carries an id and all it needs, the problem document too: a worker that was lost can be replaced by
// another without telling it anything first. A newer request makes every older one stale.
import type { Outcome, Progress, Scene, SolveOptions, Trace } from "../core.js";

/** What the page asks for. */
export type Task =
  | { kind: "open"; document: string }
  | { kind: "solve"; document: string; options: SolveOptions }
  | { kind: "trace"; document: string; plan: string[] };

/** Page to worker. `cancel` names the request it ends. */
export type Message = (Task & { id: number }) | { kind: "cancel"; id: number };

/** An outcome that may lack figures: one that was put together after its worker was lost has none. */
export type Answered = Omit<Outcome, "stats"> & { stats: Partial<Outcome["stats"]> };

/** What one task ends with, from a worker that works. */
export type Answer =
  | { kind: "opened"; scene: Scene; start: Trace }
  | { kind: "solved"; outcome: Answered; trace: Trace | null }
  | { kind: "traced"; trace: Trace }
  /** The document or the options are wrong: `message` is for the person to read. */
  | { kind: "refused"; message: string }
  /** The core panicked or could not be loaded: this worker is of no more use. */
  | { kind: "broken"; message: string };

/** Worker to page. */
export type Reply =
  /** The core is loaded. */
  | { kind: "ready" }
  /** The task is taken up. */
  | { kind: "started"; id: number }
  | (Answer & { id: number })
  | { kind: "progress"; id: number; progress: Progress };
