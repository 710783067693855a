// The candidate goals, and whether each is still possible for each observer at the step shown.
import { html, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { goalViews } from "./goal-attributes.js";
import { possible, ruledOut, star } from "./icons.js";
import { called, type Role, roles } from "./observers.js";

export function goalList(playground: Playground): TemplateResult | "" {
  const scene = playground.scene.value;
  const shown = playground.shown.value;
  if (scene === null || shown === null) return "";
  return html`<table class="goals">
    <caption>At which goal may the agent be now?</caption>
    <thead>
      <tr>
        <th scope="col">Goal</th>
        ${roles.map((role) => html`<th scope="col" class=${role}>For the ${called[role]}</th>`)}
      </tr>
    </thead>
    <tbody>
      ${goalViews(scene, shown).map(
        (goal) => html`<tr data-goal=${goal.name} data-adversarial=${goal.attributes.adversarial}
          data-cooperative=${goal.attributes.cooperative} ?data-true-goal=${goal.isTrue}>
          <th scope="row">
            <span class="name">${goal.name}</span>
            ${goal.isTrue ? html`<span class="true">${star}true goal</span>` : ""}
          </th>
          ${roles.map((role) => survival(role, goal.alive[role]))}
        </tr>`,
      )}
    </tbody>
  </table>`;
}

const survival = (role: Role, alive: boolean) =>
  alive
    ? html`<td class="${role} alive">${possible}possible</td>`
    : html`<td class="${role} dead">${ruledOut}ruled out</td>`;
