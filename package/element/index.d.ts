import type {
  AnswerDetail,
  Answered,
  ElementSolveOptions,
  PngOptions,
  ScoreDetail,
  StepDetail,
  SvgOptions,
} from "./types.js";

export type * from "./types.js";

type Text = string | null;

/** What an attribute may be set to as a property: its text, or nothing to take it away. */
type Given = string | number | null | undefined;

/** All that a link would hold. */
export interface SharedState {
  /** The problem document's text. */
  document: string;
  /** What is asked of the solver, as typed. */
  form: { [field: string]: string };
  answered?: true;
  plan?: string[];
  title?: string;
  step: number;
  tab: string;
  mode: "plan" | "walk" | "guess";
  extra?: number;
  patience?: number;
  /** The answer to an exercise. */
  answer?: { choices: number[]; attempts: number; hints: number; checked?: { code: string; score: number } };
}

export declare class MoCoppPlayground extends HTMLElement {
  /** Settles once the first picture is drawn, or cannot be. */
  readonly ready: Promise<this>;
  /**
   * The problem document that is open, or is being opened: a copy, of which a change changes nothing before it is set.
   * Set, as an object or as its text, it is opened.
   */
  get document(): object | null;
  set document(value: object | string | null);
  /** All that a link would hold. Kept and set again, the playground is as it was. */
  get state(): SharedState | null;
  set state(value: SharedState | null);
  // Attributes: docs/embedding.md says what each is for.
  get src(): Text;
  set src(value: Given);
  get problem(): Text;
  set problem(value: Given);
  get plan(): Text;
  set plan(value: Given | readonly string[]);
  get step(): Text;
  set step(value: Given);
  get solver(): Text;
  set solver(value: Given);
  get k(): Text;
  set k(value: Given);
  get j(): Text;
  set j(value: Given);
  get horizon(): Text;
  set horizon(value: Given);
  get hide(): Text;
  set hide(value: Given | readonly string[]);
  get link(): Text;
  set link(value: Given);
  get theme(): Text;
  set theme(value: Given);
  get keys(): Text;
  set keys(value: Given);
  get exercise(): Text;
  set exercise(value: Given | object);
  get seed(): Text;
  set seed(value: Given);
  get student(): Text;
  set student(value: Given);
  get name(): Text;
  set name(value: Given);
  get loading(): Text;
  set loading(value: Given);
  get workerUrl(): Text;
  set workerUrl(value: Given);
  get wasmUrl(): Text;
  set wasmUrl(value: Given);
  watch: boolean;
  /** A form is not sent before an answer was checked. */
  required: boolean;
  disabled: boolean;
  /** The form that the element is a field of. */
  readonly form: HTMLFormElement | null;
  readonly type: string;
  /** The answer code that the form sends; empty while there is none. */
  readonly value: string;
  readonly validity: ValidityState | undefined;
  readonly validationMessage: string;
  readonly willValidate: boolean;
  /** Whether there is an answer code, or none is required. */
  checkValidity(): boolean;
  reportValidity(): boolean;
  /** Shows a step; one beyond the last is the last. Rejects with a sentence where that is no whole number from 0. */
  goTo(step: number): Promise<void>;
  /** Solves the open problem; rejects with a sentence where the options do not fit or are not the element's. */
  solve(options?: ElementSolveOptions | null): Promise<Answered>;
  /**
   * The step shown as the text of an SVG picture, the same as `mo-copp picture` writes; with `walk` all steps, animated.
   * Rejects with a sentence where there is nothing to draw, or an option does not fit.
   */
  toSVG(options?: SvgOptions | null): Promise<string>;
  /** The step shown as a PNG, the picture of `toSVG` at twice its size. */
  toPNG(options?: PngOptions | null): Promise<Blob>;
}

/** What a playground is drawn into: search there for `[data-goal]`, `[data-cell]`, `[data-board]`. */
export declare function inside(playground: Element): ParentNode;

declare global {
  interface HTMLElementTagNameMap {
    "mo-copp-playground": MoCoppPlayground;
  }

  /** The events bubble. */
  interface GlobalEventHandlersEventMap {
    "mo-copp-step": CustomEvent<StepDetail>;
    "mo-copp-outcome": CustomEvent<Answered>;
    "mo-copp-answer": CustomEvent<AnswerDetail>;
    "mo-copp-score": CustomEvent<ScoreDetail>;
  }
}
