// What can be done now, as buttons; where that is much, with a field that looks for words in it.
import { html, nothing, type TemplateResult } from "lit";
import type { Walk } from "../state/walk.js";
import { actionText } from "../view/action.js";
import { counted } from "../view/numbers.js";

/** More buttons than these are a list to scroll. */
const MANY = 12;
/** More buttons than these nobody looks through: the field finds the others. */
const MOST = 200;

export function chooser(walk: Walk): TemplateResult {
  const next = walk.next.value;
  if (next.length === 0) return html`<p>There is nothing left to do.</p>`;
  const many = next.length > MANY;
  const wanted = many ? walk.wanted.value : "";
  const found = next.filter(({ action }) => matches(action, wanted));
  return html`${many ? field(walk, found.length, next.length) : nothing}
    <ul class="next ${many ? "many" : ""}" aria-label="What can be done now">
      ${found
        .slice(0, MOST)
        .map(
          ({ action }) =>
            html`<li><button type="button" @click=${() => void walk.take(action)}>${actionText(action)}</button></li>`,
        )}
    </ul>
    ${found.length > MOST ? html`<p>and ${counted(found.length - MOST, "more action")}: type a word of the one you want.</p>` : nothing}`;
}

function field(walk: Walk, found: number, all: number): TemplateResult {
  return html`<label class="find">
    <span>Find an action</span>
    <input type="search" autocomplete="off" spellcheck="false" .value=${walk.wanted.value}
      @input=${(event: Event) => {
        walk.wanted.value = (event.target as HTMLInputElement).value;
      }} />
    <small role="status">${walk.wanted.value.trim() === "" ? counted(all, "action") : `${found} of ${counted(all, "action")}`}</small>
  </label>`;
}

/** Every word that was typed is in it, or the beginning of a word. */
function matches(action: string, wanted: string): boolean {
  const text = action.toLowerCase();
  return wanted
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}
