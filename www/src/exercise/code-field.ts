// The answer code, to copy.
import { html, nothing, type TemplateResult } from "lit";
import type { Exercise } from "../state/exercise.js";

const words = { "": "", copied: "Copied.", refused: "The page may not use the clipboard: select the code." };

export function codeField({ code, copier }: Exercise): TemplateResult | typeof nothing {
  const text = code.value;
  if (text === null) return nothing;
  return html`<div class="code">
    <label>Answer code, of the last answer that was checked
      <input type="text" readonly spellcheck="false" .value=${text} @focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()} />
    </label>
    <button type="button" @click=${() => void copier.copy(text)}>Copy the code</button>
    <small role="status">${words[copier.said.value]}</small>
  </div>`;
}
