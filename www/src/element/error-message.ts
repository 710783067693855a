// What could not be done, above all else: in one sentence, with a second try where that may help.
import { html, nothing, type TemplateResult } from "lit";
import type { Answer } from "../state/answer.js";
import { cross } from "../view/icons.js";

/** `stays`: there is nothing else to show, and so the message can't be closed. */
export function errorMessage(answer: Answer, stays: boolean): TemplateResult {
  const error = answer.error.value;
  return html`
    <div class="error">
      <div role="alert">${error === null ? nothing : html`<p>${error}${secondTry(answer)}</p>`}</div>
      ${
        error === null || stays
          ? nothing
          : html`<button type="button" class="sign" aria-label="Close the message" title="Close the message"
              @click=${() => answer.dismiss()}>${cross}</button>`
      }
    </div>
  `;
}

/** What failed for want of a connection or of a solver is tried again by one click. */
function secondTry(answer: Answer): TemplateResult | typeof nothing {
  const again = answer.again.value;
  return again === null ? nothing : html` <button type="button" class="again" @click=${again}>Try again</button>`;
}
