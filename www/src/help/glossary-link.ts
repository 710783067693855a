// A word of the page that leads to its definition.
import { html, type TemplateResult } from "lit";
import { openHelp } from "./help.js";
import type { Term } from "./terms.js";

/** A button and no link: the part of an address that would name the term holds the page's state. */
export function glossaryLink(term: Term, text: string | TemplateResult): TemplateResult {
  return html`<button type="button" class="term" title="What does this mean?" data-term=${term}
    @click=${(event: Event) => {
      // In a label, the field would be chosen as well.
      event.preventDefault();
      void openHelp(term, event.currentTarget as Element);
    }}>${text}</button>`;
}
