import type { Outcome, PictureOptions, SolveOptions } from "../core/mo_copp.js";

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

/** Without any: all boards of the step shown, with captions, in the playground's own colours. */
export interface SvgOptions extends Omit<PictureOptions, "animate"> {
  /** All steps of what is shown, one after another, without end. */
  walk?: boolean;
}

export declare class MoCoppPlayground extends HTMLElement {
  /** Settles once the first picture is drawn, or cannot be. */
  readonly ready: Promise<this>;
  /** The problem document that is open. Set, as an object or as its text, it is opened. */
  get document(): object | null;
  set document(value: object | string | null);
  /** All that a link would hold. Kept and set again, the playground is as it was. */
  get state(): SharedState | null;
  set state(value: SharedState | null);
  /** Shows a step; one beyond the last is the last. */
  goTo(step: number): Promise<void>;
  /** Solves the open problem; rejects with a sentence where the options do not fit. */
  solve(options?: Partial<SolveOptions>): Promise<Omit<Outcome, "stats"> & { stats: Partial<Outcome["stats"]> }>;
  /**
   * The step shown as the text of an SVG picture, the same as `mo-copp picture` writes; with `walk` all steps, animated.
   * Rejects with a sentence where there is nothing to draw, or an option does not fit.
   */
  toSVG(options?: SvgOptions): Promise<string>;
}

/** What a playground is drawn into: search there for `[data-goal]`, `[data-cell]`, `[data-board]`. */
export declare function inside(playground: Element): ParentNode;

declare global {
  interface HTMLElementTagNameMap {
    "mo-copp-playground": MoCoppPlayground;
  }
}
