// Lists of very many entries: the first are shown, and all of them once that is asked for. A browser takes long to lay
// out thousands of entries, and to lay them out anew with every step.
import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import { wholeNumber } from "./numbers.js";

/** More than these are shown when that is asked for. */
const MOST = 100;

/** Of which parts of the page all entries are shown. */
const whole = new WeakMap<object, { value: boolean }>();

function wholeOf(owner: object): { value: boolean } {
  const known = whole.get(owner) ?? signal(false);
  whole.set(owner, known);
  return known;
}

/** Whether all entries of the lists of this owner are shown. */
export const isWhole = (owner: object): boolean => wholeOf(owner).value;

export interface LongList<Item> {
  shown: readonly { item: Item; index: number }[];
  /** The button that shows all entries, or fewer again; it belongs behind the list. */
  more: TemplateResult | typeof nothing;
}

/** The lists of one `owner` are opened together; what is `needed` is shown in any case. */
export function longList<Item>(
  owner: object,
  items: readonly Item[],
  noun: string,
  needed: (item: Item) => boolean = () => false,
): LongList<Item> {
  const all = wholeOf(owner);
  const numbered = items.map((item, index) => ({ item, index }));
  if (items.length <= MOST) return { shown: numbered, more: nothing };
  const shown = all.value ? numbered : numbered.filter(({ item, index }) => index < MOST || needed(item));
  const toggle = () => {
    all.value = !all.value;
  };
  return {
    shown,
    more: html`<p class="more"><button type="button" class="small" aria-expanded=${String(all.value)} @click=${toggle}>${
      all.value ? `Show ${MOST} ${noun}` : `Show all ${wholeNumber(items.length)} ${noun}`
    }</button></p>`,
  };
}
