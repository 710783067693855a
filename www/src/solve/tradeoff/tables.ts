// The two charts' twins: the same points as tables, each with a button that shows its plan.
import { html, type TemplateResult } from "lit";
import type { LengthPoint } from "../../core.js";
import { differenceText } from "../../view/numbers.js";
import type { ShownLength } from "./length-points.js";
import type { PairPoint } from "./pair-points.js";

export function pairsTable(points: readonly PairPoint[]): TemplateResult {
  return twin(
    "The pairs as a table",
    ["Enemy", "Friend", "Goal difference", "Moves", "Plan"],
    points.map(
      (point) => html`<tr>
      <td>${point.adversarial}</td><td>${point.cooperative}</td>
      <td>${differenceText(point.difference)}${point.best ? " (best)" : ""}${point.outside ? " (outside the bounds)" : ""}</td>
      <td>${point.plan.length}</td><td>${button(point)}</td></tr>`,
    ),
  );
}

export function lengthsTable(points: readonly ShownLength[], lengths: readonly LengthPoint[]): TemplateResult {
  return twin(
    "The lengths as a table",
    ["Moves", "Goal difference", "Enemy", "Friend", "Plan"],
    lengths.map((length) => {
      const point = points.find((other) => other.length === length.length);
      return point === undefined
        ? html`<tr><td>${length.length}</td><td colspan="4">no plan</td></tr>`
        : html`<tr>
          <td>${point.length}</td><td>${differenceText(point.goal_difference)}${point.best ? " (best)" : ""}</td>
          <td>${point.adversarial}</td><td>${point.cooperative}</td><td>${button(point)}</td></tr>`;
    }),
  );
}

const button = ({ name, shown, choose }: PairPoint | ShownLength): TemplateResult =>
  html`<button type="button" class="small" aria-pressed=${String(shown)} aria-label="Show ${name}" @click=${choose}>Show</button>`;

function twin(title: string, heads: readonly string[], rows: TemplateResult[]): TemplateResult {
  return html`<details class="twin"><summary>${title}</summary>
    <table><thead><tr>${heads.map((head) => html`<th scope="col">${head}</th>`)}</tr></thead><tbody>${rows}</tbody></table>
  </details>`;
}
