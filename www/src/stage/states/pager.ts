// Which of several pictures are shown on an observer's board, and the buttons that leaf through them.
import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import { left, right } from "../../view/icons.js";
import { wholeNumber } from "../../view/numbers.js";
import { called, type Role } from "../../view/observers.js";

/** By the playground that they belong to. */
const turns = new WeakMap<object, Record<Role, { value: number }>>();

function turnOf(playground: object, role: Role): { value: number } {
  const known = turns.get(playground) ?? { adversarial: signal(0), cooperative: signal(0) };
  turns.set(playground, known);
  return known[role];
}

export interface Page {
  first: number;
  count: number;
}

/** The page that is open; a belief with fewer states has fewer pages. */
export function pageOf(playground: object, role: Role, states: number, atOnce: number): Page {
  const pages = Math.max(1, Math.ceil(states / atOnce));
  const first = Math.min(turnOf(playground, role).value, pages - 1) * atOnce;
  return { first, count: Math.min(atOnce, states - first) };
}

/** `listed`: how many states there are to look at, of `all`. */
export function pager(
  playground: object,
  role: Role,
  { first, count }: Page,
  atOnce: number,
  listed: number,
  all: number,
): TemplateResult | typeof nothing {
  const pages = Math.ceil(listed / atOnce);
  if (pages <= 1) return nothing;
  const at = Math.floor(first / atOnce);
  const turn = (way: number) => {
    turnOf(playground, role).value = (at + way + pages) % pages;
  };
  const shown = count === 1 ? `State ${first + 1}` : `States ${first + 1} to ${first + count}`;
  return html`<p class="pager">
    <button type="button" class="sign" aria-label=${`Before: states of the ${called[role]}`} @click=${() => turn(-1)}>${left}</button>
    <span>${shown} of ${wholeNumber(all)}${listed < all ? html` <small>(the first ${wholeNumber(listed)} can be looked at)</small>` : nothing}</span>
    <button type="button" class="sign" aria-label=${`Next: states of the ${called[role]}`} @click=${() => turn(1)}>${right}</button>
  </p>`;
}
