// What the solver is doing, or what it answered and whose plan is shown.

import type { ReadonlySignal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import type { Answer, Result } from "../state/answer.js";
import { type Form, solvers } from "../state/form.js";
import { counted, differenceText } from "../view/numbers.js";
import { type InfeasibleStores, infeasible } from "./infeasible.js";
import { type ShownPlanStores, shownPlan } from "./shown-plan.js";
import { caveat, scope, verdict } from "./verdict.js";
import { work } from "./work.js";

export interface ResultStores extends InfeasibleStores, ShownPlanStores {
  answer: Answer;
  form: ReadonlySignal<Form>;
}

export function result(playground: ResultStores): TemplateResult {
  const solving = playground.answer.status.value === "solving" && playground.answer.slow.value;
  const last = playground.answer.result.value;
  // Only the answer is announced: progress changes many times a second.
  return html`<div class="result">
    ${solving ? working(playground) : nothing}
    <div role="status">${solving || last === null ? nothing : answered(last, playground.answer.optimum.value)}</div>
    ${solving || last === null ? nothing : further(playground, last)} ${shownPlan(playground)}
  </div>`;
}

function working(playground: ResultStores): TemplateResult {
  return html`${work(playground.answer.progress.value, playground.answer.stopwatch.seconds.value, "Solving")}
    <button type="button" @click=${() => playground.solving.cancel()}>Cancel</button>
    <small>The best plan found so far is kept.</small>`;
}

function answered(last: Result, optimum: Result | null): TemplateResult {
  const { options } = last;
  return html`<p><b>${solvers[options.solver].title}: ${verdict(last)}${scope(last)}.</b> ${figures(last)} ${caveat(last, optimum)}</p>`;
}

function figures({ outcome }: Result): string {
  const { plan, goal_difference } = outcome;
  if (plan === null || goal_difference === null) return "";
  return `Goal difference ${differenceText(goal_difference)} in ${counted(plan.length, "move")}.`;
}

/** What can be done from here: with no plan the nearest that has one, else the solver that was chosen. */
function further(playground: ResultStores, last: Result): TemplateResult {
  const { solver } = playground.form.value;
  const other = solver !== last.options.solver && solver === playground.answer.ran.value;
  const stopped = solver === "exact" && ["feasible", "limit"].includes(last.outcome.status);
  return html`${last.outcome.status === "infeasible" ? infeasible(playground, last) : nothing}
    ${
      other || stopped
        ? html`<button type="button" class="again" @click=${() => playground.solving.solve()}>
            Solve again${other ? ` with ${solvers[solver].title}` : ""}</button>`
        : nothing
    }`;
}
