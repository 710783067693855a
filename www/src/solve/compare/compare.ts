// All solvers side by side: the bounds they keep to, starting and ending them, and what each found.
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import type { Gallery } from "../../gallery/gallery.js";
import { patiences } from "../../state/comparison.js";
import { counted } from "../../view/numbers.js";
import { saveTable } from "../../view/save-table.js";
import { type NumberFieldStores, numberField } from "../number-field.js";
import { type ShownPlanStores, shownPlan } from "../shown-plan.js";
import { work } from "../work.js";
import { comparisonFile } from "./file.js";
import { type ComparisonTableStores, comparisonTable } from "./table.js";

export interface CompareStores extends NumberFieldStores, ComparisonTableStores, ShownPlanStores {
  gallery: Gallery;
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
    ${again ? html`${asked(playground)} ${comparisonTable(playground)} ${saveTable("the comparison", comparisonFile(playground))}` : nothing}
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

/** Four of the solvers need bounds: without, the first plan they find is all they say. */
function suggestion({ comparison }: Pick<CompareStores, "comparison">): TemplateResult | typeof nothing {
  const bounds = comparison.suggested.value;
  if (bounds === null) return nothing;
  const choose = (event: Event) => {
    comparison.bounded.value = (event.target as HTMLInputElement).checked;
  };
  return html`<div class="hint">
    <label><input type="checkbox" .checked=${live(comparison.bounded.value)} @change=${choose} />
      Ask for what the best plan reaches: k = ${bounds.k}, j = ${bounds.j}</label>
    <small>Without bounds, satisficing and heuristic search, obfuscate and legible have nothing to keep to and take the first
      plan they find.</small>
  </div>`;
}

/** What the solvers of the table were asked for. */
function asked({ comparison }: Pick<CompareStores, "comparison">): TemplateResult | typeof nothing {
  const numbers = comparison.asked.value?.numbers;
  if (numbers === undefined) return nothing;
  const { k, j, horizon } = numbers;
  const parts = [
    ...(k === "" ? [] : [`k = ${k}`]),
    ...(j === "" ? [] : [`j = ${j}`]),
    ...(horizon === "" ? [] : [`plans of ${counted(Number(horizon), "move")}`]),
  ];
  return html`<p class="asked-for">Asked for: ${parts.length === 0 ? "plans of any length, without bounds" : parts.join(", ")}.</p>`;
}
