// What each solver found. The solver's name is the button that shows its plan.
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Boards } from "../../state/boards.js";
import type { Comparison, Row } from "../../state/comparison.js";
import type { Plans } from "../../state/plans.js";
import { differenceText, duration } from "../../view/numbers.js";
import { proved, verdict } from "../verdict.js";

export interface ComparisonTableStores {
  comparison: Comparison;
  boards: Boards;
  plans: Plans;
}

const heads = ["Solver", "Answer", "Goal difference", "Enemy", "Friend", "Moves", "Time"] as const;

export function comparisonTable(playground: ComparisonTableStores): TemplateResult {
  const { rows, outdated } = playground.comparison;
  // A table that is laid out as a grid on narrow screens is a table all the same.
  return html`<table class="comparison" role="table" data-outdated=${outdated.value || nothing}>
    <caption class="unseen">What each solver found</caption>
    <thead role="rowgroup">
      <tr role="row">${heads.map((head) => html`<th role="columnheader" scope="col">${head}</th>`)}</tr>
    </thead>
    <tbody role="rowgroup">${rows.value.map((row) => line(playground, row, outdated.value))}</tbody>
  </table>`;
}

/** What the boards say of a plan of the comparison. */
export const planTitle = ({ entrant }: Row): string => `the plan of ${entrant.title}`;

function line(playground: ComparisonTableStores, row: Row, outdated: boolean): TemplateResult {
  const outcome = row.result?.outcome;
  const plan = outcome?.plan ?? null;
  const shown = !outdated && plan !== null && playground.boards.chosen.value === planTitle(row);
  const cell = (label: string, content: unknown, kind = "") =>
    html`<td role="cell" class=${kind} data-label=${label}>${content}</td>`;
  // Who has answered without a plan has none; the others have said nothing yet.
  const none = row.state === "answered" ? html`<span class="none">none</span>` : "";
  return html`<tr role="row" data-state=${row.state} data-shown=${shown || nothing}>
    <th role="rowheader" scope="row">
      ${
        plan === null || outdated
          ? html`<span class="solver-name">${row.entrant.title}</span>`
          : html`<button type="button" class="small" aria-pressed=${String(shown)}
              @click=${() => playground.plans.show(plan, planTitle(row))}>${row.entrant.title}</button>`
      }
      ${row.entrant.note === undefined ? nothing : html`<small class="slow">${row.entrant.note}</small>`}
    </th>
    ${cell("Answer", answer(row), "answer")}
    ${cell("Goal difference", outcome?.goal_difference == null ? none : difference(outcome.goal_difference), "figure gd")}
    ${cell("Enemy", outcome?.goals?.adversarial.length ?? none, "figure enemy")}
    ${cell("Friend", outcome?.goals?.cooperative.length ?? none, "figure friend")}
    ${cell("Moves", plan?.length ?? none, "figure")} ${cell("Time", row.seconds === undefined ? "" : duration(row.seconds), "figure")}
  </tr>`;
}

function answer(row: Row): TemplateResult | string {
  if (row.state === "running") return "at work…";
  if (row.state === "waiting") return "waits";
  if (row.state === "left out") return "not run";
  if (row.result === undefined) return html`<span class="failed" role="alert">${row.message ?? ""}</span>`;
  return html`${verdict(row.result)}${proved(row.result)}${row.ended === undefined ? nothing : html` <small>(${row.ended})</small>`}`;
}

/** The number with a bar that grows from the middle: to the right for the good side. */
function difference(value: number): TemplateResult {
  const width = Math.abs(value) * 24;
  return html`<span class="bar-value">${differenceText(value)}</span><svg class="bar" viewBox="0 0 48 8" aria-hidden="true">
    ${svg`<rect class="track" width="48" height="8" rx="2"></rect>
      <rect class=${value < 0 ? "less" : "more"} x=${value < 0 ? 24 - width : 24} width=${width} height="8"></rect>
      <line x1="24" x2="24" y1="0" y2="8"></line>`}</svg>`;
}
