// What a domain of listed states has to offer so that its states can be shown.
import type { TemplateResult } from "lit";
import type { BeliefSummary, State } from "../../core.js";

export interface StateKind {
  /** One state as a picture. `small`: among several. */
  picture(state: State, small: boolean): TemplateResult;
  /** One state in a sentence, for those who do not see the picture. */
  described(state: State): string;
  /** A fact in words: "a is on b". */
  words(fact: string): string;
  /** How many pictures fit beside each other on a board. */
  atOnce: number;
  /** All states of a belief in one picture. */
  merged?(summary: BeliefSummary): TemplateResult;
  /** The candidate goals beside the pictures, where they can be drawn. */
  goals?: (index: number) => TemplateResult;
  goal(index: number): TemplateResult | string;
}
