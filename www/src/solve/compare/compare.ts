// All solvers side by side: the bounds they keep to, starting and ending them, and what each found.
import { html, nothing, type TemplateResult } from "lit";
import type { Answer } from "../../state/answer.js";
import { patiences } from "../../state/comparison.js";
import { counted } from "../../view/numbers.js";
import { type NumberFieldStores, numberField } from "../number-field.js";
import { type ShownPlanStores, shownPlan } from "../shown-plan.js";
import { work } from "../work.js";
import { type ComparisonTableStores, comparisonTable } from "./table.js";

export interface CompareStores extends NumberFieldStores, ComparisonTableStores, ShownPlanStores {
  answer: Answer;
}

export function compare(playground: CompareStores): TemplateResult {
  const { comparison } = playground;
  const running = comparison.running.value;
  const outdated = comparison.outdated.value;
  const again = comparison.started.value;
  const end = comparison.cancelled.value ? "The comparison was cancelled." : "The comparison is complete.";
  return html`<div class="compare">
    <p class="lead">Every solver on this problem, one after another. Choose one to see its plan on the boards.</p>
    <div class="solver">
      ${(["k", "j", "horizon"] as const).map((name) => numberField(playground, name, `compare-${name}`))}
      ${suggestion(playground)}
      <div class="actions">
        ${
          running && !outdated
            ? html`<button type="button" @click=${() => comparison.skip()}>Skip this one</button>
                <button type="button" @click=${() => comparison.cancel()}>Cancel</button>`
            : html`<button type="button" class="primary" ?disabled=${playground.boards.scene.value === null}
                @click=${() => comparison.start()}>${again ? "Compare again" : "Compare all solvers"}</button>`
        }
        ${patienceField(playground)}
      </div>
    </div>
    ${outdated ? html`<p class="outdated">These results are of an earlier problem, or of other bounds.</p>` : nothing}
    ${running && !outdated ? atWork(playground) : nothing}
    ${again ? comparisonTable(playground) : nothing}
    <div role="status" class="unseen">${again && !running && !outdated ? end : nothing}</div>
    ${shownPlan(playground)}
  </div>`;
}

function atWork(playground: CompareStores): TemplateResult | typeof nothing {
  const { rows, progress, stopwatch } = playground.comparison;
  const row = rows.value.find(({ state }) => state === "running");
  if (row === undefined) return nothing;
  const { title } = row.entrant;
  return html`<div class="at-work"><b>${title}</b> ${work(progress.value, stopwatch.seconds.value, title)}</div>`;
}

function patienceField({ comparison }: Pick<CompareStores, "comparison">): TemplateResult {
  const choose = (event: Event) => {
    comparison.patience.value = Number((event.target as HTMLSelectElement).value);
  };
  return html`<label class="patience">Each may take
    <select @change=${choose}>
      ${patiences.map(
        (seconds) =>
          html`<option value=${seconds} .selected=${seconds === comparison.patience.value}>${
            Number.isFinite(seconds) ? counted(seconds, "second") : "as long as it likes"
          }</option>`,
      )}
    </select></label>`;
}

/** Three of the solvers need bounds: without, the first plan they find is all they say. */
function suggestion(playground: CompareStores): TemplateResult | typeof nothing {
  const { k, j } = playground.form.value;
  const goals = playground.answer.optimum.value?.outcome.goals;
  if (k !== "" || j !== "" || goals === undefined || goals === null) return nothing;
  const bounds = { k: String(goals.adversarial.length), j: String(goals.cooperative.length) };
  return html`<p class="hint">Without bounds, heuristic search, obfuscate and legible have nothing to keep to and take
    the first plan they find.
    <button type="button" class="small" @click=${() => playground.solving.edit(bounds)}>
      Ask for what the best plan reaches: k = ${bounds.k}, j = ${bounds.j}</button></p>`;
}
