// States to choose from: a list, and where they are many, a box to scroll in with a field to search by, in groups by the
// first part of the states.
import { html, nothing, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import type { Question, State } from "../core.js";
import type { Exercise } from "../state/exercise.js";
import { actionText } from "../view/action.js";
import { counted } from "../view/numbers.js";
import { between, placeText, stateText } from "./state-text.js";

/** Fewer states are seen at once. */
const FEW = 12;

interface Item {
  index: number;
  /** The state in words. */
  text: string;
  /** What the states of its group have in common; empty where a state has no parts. */
  group: string;
  /** The rest of it. */
  rest: string;
}

export function stateList(exercise: Exercise, question: Question): TemplateResult {
  const items = itemsOf(question.form.choices);
  const option = (item: Item, text: string) => html`<label><input type="checkbox" name="choice" aria-label=${item.text}
    .checked=${exercise.choices.value.includes(item.index)} @change=${() => exercise.choose(item.index)} /> ${text}</label>`;
  if (items.length <= FEW)
    return html`<fieldset class="choices">
      <legend>States that are possible</legend>
      ${items.map((item) => option(item, item.text))}
    </fieldset>`;
  const shown = found(items, exercise.filter.value);
  const chosen = exercise.choices.value.length;
  return html`<fieldset class="choices">
    <legend>States that are possible</legend>
    <label class="search">Search
      <input type="search" autocomplete="off" spellcheck="false" .value=${exercise.filter.value}
        @input=${(event: Event) => {
          exercise.filter.value = (event.target as HTMLInputElement).value;
        }} />
    </label>
    <p class="count" role="status">${shown.length === items.length ? "" : `${shown.length} of `}${counted(items.length, "state")}, ${chosen} chosen.</p>
    <div class="states" role="group" tabindex="0" aria-label="States">${repeat(
      grouped(shown),
      ([group]) => group,
      ([group, members]) =>
        group === ""
          ? members.map((item) => option(item, item.text))
          : html`<div role="group" aria-label=${group}><p class="group">${group}</p>${members.map((item) => option(item, item.rest))}</div>`,
    )}${shown.length === 0 ? html`<p>No state has these words.</p>` : nothing}</div>
  </fieldset>`;
}

let known: { choices: readonly State[]; items: readonly Item[] } | null = null;

/** Each key that is typed would have all of them written anew. */
function itemsOf(choices: readonly State[]): readonly Item[] {
  if (known?.choices !== choices) known = { choices, items: choices.map(itemOf) };
  return known.items;
}

function itemOf(state: State, index: number): Item {
  const text = stateText(state);
  if (typeof state !== "object") return { index, text, group: "", rest: text };
  if (Array.isArray(state)) {
    const [first, ...others] = state.map((fact) => actionText(String(fact)));
    return { index, text, ...parted(first, others.join(", "), text) };
  }
  const [first, ...others] = Object.entries(state).map(([part, value]) => `${part} ${placeText(value)}`);
  return { index, text, ...parted(first, others.join(between), text) };
}

/** A state of one part has no group: the part is all that would be said of it. */
const parted = (first: string | undefined, rest: string, text: string) =>
  first === undefined || rest === "" ? { group: "", rest: text } : { group: first, rest };

/** A cell as documents write it, and all that parts words. */
const plain = (text: string): string =>
  text
    .toLowerCase()
    .replace(/\[\s*(\d+)\s*,\s*(\d+)\s*\]/g, "column $1, row $2")
    .replace(/\s+/g, " ")
    .replace(/ ?[,·] ?/g, ", ")
    .trim();

/** Text that begins a word and ends at will, but for numbers: 1 is no part of 12. */
const begins = (text: string): RegExp =>
  new RegExp(`(?<![\\p{L}\\d])${text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}${/\d$/.test(text) ? "(?!\\d)" : ""}`, "u");

/** Those with what is typed as it stands; where there is none, those with all parts of it between commas. */
function found(items: readonly Item[], typed: string): readonly Item[] {
  const wanted = plain(typed).replace(/^, |,$/g, "");
  if (wanted === "") return items;
  const having = (parts: readonly string[]) => {
    const patterns = parts.map(begins);
    return items.filter(({ text }) => patterns.every((pattern) => pattern.test(plain(text))));
  };
  const whole = having([wanted]);
  return whole.length > 0 ? whole : having(wanted.split(", ").filter((part) => part !== ""));
}

function grouped(items: readonly Item[]): [string, Item[]][] {
  const groups = new Map<string, Item[]>();
  for (const item of items) groups.set(item.group, [...(groups.get(item.group) ?? []), item]);
  return [...groups];
}
