// The walk that shows what is wrong with an answer, step by step with its symbols.
import { html, type TemplateResult } from "lit";
import type { Counterexample } from "../core.js";
import { actionText } from "../view/action.js";
import { called } from "../view/observers.js";

export function counterexample({ observer, actions, symbols, differs }: Counterexample): TemplateResult | string {
  if (actions.length === 0) return "";
  return html`<div class="steps-shown" role="region" tabindex="0" aria-label="The walk step by step"><table>
    <thead><tr><th scope="col">Step</th><th scope="col">Action</th><th scope="col">What the ${called[observer]} is told</th></tr></thead>
    <tbody>${actions.map(
      (action, index) => html`<tr class=${index + 1 === differs ? "differs" : ""}>
        <td>${index + 1}</td><td>${actionText(action)}</td>
        <td>${symbols[index]}${index + 1 === differs ? " (it was told another symbol)" : ""}</td></tr>`,
    )}</tbody></table></div>`;
}
