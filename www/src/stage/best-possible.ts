// The best that any plan can reach, always on the screen, and what the plan shown reaches of it.
import { html, nothing, type TemplateResult } from "lit";
import type { Answer, Result } from "../state/answer.js";
import type { Boards } from "../state/boards.js";
import type { OpenProblem } from "../state/open-problem.js";
import { counted, differenceText } from "../view/numbers.js";

export interface BestPossibleStores {
  answer: Answer;
  boards: Boards;
  problem: OpenProblem;
}

/** `labelled`: what the number is stands beside it already. */
export function bestPossible(playground: BestPossibleStores, labelled: boolean): TemplateResult | typeof nothing {
  if (playground.problem.closed.value) return nothing;
  const optimum = playground.answer.optimum.value;
  const shown = playground.boards.difference.value;
  const best = optimum?.outcome.goal_difference ?? null;
  const less = best !== null && shown !== null && shown < best - 1e-9;
  if (isImpossible(playground)) return html`<p class="best">No plan can do what is asked.</p>`;
  const thing = labelled ? "" : " goal difference";
  return html`<p class="best">${optimum === null ? `Best possible${thing}: …` : words(optimum, thing)}${
    less ? html` · <span class="less">this plan: <b>${differenceText(shown)}</b></span>` : ""
  }</p>`;
}

/** It is proved that no plan does what is asked. */
export const isImpossible = ({ answer: { optimum, result } }: Pick<BestPossibleStores, "answer">): boolean =>
  (optimum.value ?? result.value)?.outcome.status === "infeasible";

function words({ options, outcome }: Result, thing: string): TemplateResult {
  const { status, goal_difference, limit } = outcome;
  if (goal_difference === null) return html`Best possible${thing}: not known${limit === undefined ? "" : " (stopped)"}`;
  const value = html`<b>${differenceText(goal_difference)}</b>`;
  if (status !== "optimal") return html`Best${thing} found: ${value}`;
  const { horizon, k, j } = options;
  const length = typeof horizon === "number" ? ` of ${counted(horizon, "move")}` : "";
  const bounds = k === undefined && j === undefined ? "" : " within bounds";
  return html`Best${length === "" && bounds === "" ? " possible" : ""}${thing}${length + bounds}: ${value}`;
}
