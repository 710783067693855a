// What the page and its worker say to each other.
//
// Each request carries an id and all it needs, the problem document too: a worker that was lost can be replaced by
// another without telling it anything first. A newer request makes every older one stale.
import type {
  Advice,
  DocumentError,
  Eliminations,
  ExerciseVerdict,
  NextAction,
  Outcome,
  PictureOptions,
  Progress,
  Question,
  Scene,
  SolveOptions,
  Trace,
  TraceStep,
} from "../core.js";

import type { Hello } from "./greeting.js";

/** A variant of an exercise: by number, or that of a name. */
export type Seed = number | { name: string };

/** What the page asks for. */
export type Task =
  /** Read a document, solve it and replay the plan, all in one turn. */
  | { kind: "solve"; document: string; options: SolveOptions }
  /** Read a document, and solve nothing. */
  | { kind: "begin"; document: string }
  /** Only say whether a document is right. */
  | { kind: "check"; document: string }
  | { kind: "trace"; document: string; plan: string[] }
  /** Replay a plan, and tell what can be done after it. */
  | { kind: "walk"; document: string; plan: string[] }
  /** Why a goal is not possible for each observer after a step of a plan. */
  | { kind: "explain"; document: string; plan: string[]; goal: string; step: number }
  /** A step of a plan, or all of them, as SVG. */
  | { kind: "picture"; document: string; plan: string[]; options: PictureOptions }
  /** The question of a document with an exercise. */
  | { kind: "exercise"; document: string; seed: Seed }
  /** Whether the exercise of a document can be asked, what makes it trivial, and what is wrong with its variants. */
  | { kind: "prove"; document: string }
  /** What is said of an answer to it. */
  | { kind: "judge"; document: string; seed: Seed; choices: readonly number[]; attempts: number; hints: number }
  /** Pictures of the end of a plan, one a board, and what can be done after it. */
  | { kind: "sketch"; document: string; plan: string[]; boards: readonly Board[]; options: PictureOptions }
  /** Why there is no plan with these options, and which change of one of them would allow one. */
  | { kind: "advise"; document: string; options: SolveOptions };

export type Board = "actor" | "adversarial" | "cooperative";

/** Page to worker. `cancel` names the request it ends; `ahead`: there is time to fetch the full core. */
export type Message = (Task & { id: number }) | { kind: "cancel"; id: number } | { kind: "ahead" };

/** Page to worker: where a core is, or, where the worker cannot fetch it by itself, the core, or why there is none. */
export type CoreMessage =
  | { kind: "light" | "full"; core: string | ArrayBuffer }
  | { kind: "light" | "full"; core: null; error: string };

/** What is wrong with a document, and where. */
export type Fault = Pick<DocumentError, "message" | "place" | "path" | "line" | "column" | "found" | "expected">;

/** An outcome that may lack figures: one that was put together after its worker was lost has none. */
export type Answered = Omit<Outcome, "stats"> & { stats: Partial<Outcome["stats"]> };

/** What a worker tells while it is at a task. */
export type Update =
  /** The task is taken up, or taken up again. */
  | { kind: "started" }
  /** The task takes the full core, which is being fetched. */
  | { kind: "fetching" }
  | { kind: "progress"; progress: Progress }
  /** The document is right; solving takes longer, or cannot start. */
  | { kind: "opened"; scene: Scene; start: Trace };

/** What one task ends with, from a worker that works. */
export type Answer =
  /** Without a plan, `trace` is the start alone. */
  | { kind: "solved"; scene: Scene; outcome: Answered; trace: Trace }
  | { kind: "begun"; scene: Scene; start: Trace }
  | { kind: "checked"; fault: Fault | null }
  | { kind: "traced"; trace: Trace }
  | { kind: "walked"; trace: Trace; next: NextAction[] }
  | { kind: "explained"; eliminations: Eliminations }
  | { kind: "advised"; advice: Advice }
  | { kind: "drawn"; svg: string }
  | { kind: "asked"; question: Question }
  /** `states`: how many there are to choose from, where the answer is made of states. */
  | { kind: "proved"; fault: Fault | null; remarks: readonly string[]; variants: readonly string[]; states: number }
  | { kind: "judged"; verdict: ExerciseVerdict }
  | { kind: "sketched"; pictures: string[]; next: NextAction[]; last: TraceStep | null }
  /** The document, the plan or the options are wrong: `message` is for the person to read. `unloaded`: nothing is wrong
   * but that the full core, which this takes, could not be loaded. */
  | { kind: "refused"; message: string; unloaded?: true }
  /** The core panicked or could not be loaded: this worker is of no more use. `advised`: the message says what helps. */
  | { kind: "broken"; message: string; forbidden?: true; advised?: true };

/** Worker to page. */
export type Reply =
  /** The first word of a worker: whose script it is. */
  | Hello
  /** The core is loaded. */
  | { kind: "ready" }
  /** The full core is needed, by a worker that cannot fetch it. */
  | { kind: "ask" }
  | (Answer & { id: number })
  | (Update & { id: number });
