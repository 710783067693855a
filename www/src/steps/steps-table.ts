// The table of the steps: what the boards show, in words and numbers. Choosing a row shows its step.

import { html, nothing, type TemplateResult } from "lit";
import type { Gallery } from "../gallery/gallery.js";
import { glossaryLink } from "../help/glossary-link.js";
import type { Term } from "../help/terms.js";
import type { Boards } from "../state/boards.js";
import type { Timeline } from "../state/timeline.js";
import { download } from "../view/download.js";
import { named, visible } from "../view/names.js";
import { differenceText } from "../view/numbers.js";
import { called, type Role } from "../view/observers.js";
import { csv } from "./csv.js";
import { rolesSeen, type StepRow, stepRows } from "./row.js";

export interface StepsTableStores {
  timeline: Timeline;
  boards: Boards;
  gallery: Gallery;
}

export const stepsTable = (playground: StepsTableStores): TemplateResult | "" => table(playground, glossaryLink);

/** A browser repeats the words of a heading on each sheet, but no button in it. */
export const stepsOnPaper = (playground: StepsTableStores): TemplateResult | "" =>
  table(playground, (_, words) => words);

/** `heading`: how a word of the glossary stands in the headings. */
function table(
  playground: StepsTableStores,
  heading: (term: Term, words: string) => TemplateResult | string,
): TemplateResult | "" {
  const { timeline } = playground;
  const trace = timeline.trace.value;
  if (trace === null) return "";
  const guessing = playground.boards.mode.value === "guess";
  const seen = rolesSeen(playground.boards.mode.value);
  // As the enemy one sees what has come, not what will.
  const rows = stepRows(trace).slice(0, guessing ? timeline.step.value + 1 : undefined);
  return html`<div class="steps">
    <div class="steps-scroll" tabindex="0" role="region" aria-label="Table of the steps">
      <table>
        <caption class="unseen">The steps: what was done, what each observer was told, and what is possible then</caption>
        <thead>
          <tr>
            <th scope="col" rowspan="2">Step</th>
            ${guessing ? nothing : html`<th scope="col" rowspan="2">Action</th>`}
            ${seen.map((role) => html`<th scope="colgroup" colspan="3" class=${role}>The ${called[role]}</th>`)}
            ${guessing ? nothing : html`<th scope="col" rowspan="2">${heading("goal-difference", "GD")}</th>`}
          </tr>
          <tr>
            ${seen.map(
              (role) => html`<th scope="col" class=${role}>${heading("symbol", "was told")}</th>
                <th scope="col">${heading("belief", "believes")}</th><th scope="col">${heading("possible", "possible")}</th>`,
            )}
          </tr>
        </thead>
        <tbody>
          ${rows.map((step) => row(playground, step, seen, guessing))}
        </tbody>
      </table>
    </div>
    ${
      guessing
        ? nothing
        : html`<div class="actions">
            <button type="button" @click=${() => save(playground)}>Save as CSV</button>
            <small>For a spreadsheet: one line a step.</small>
          </div>`
    }
  </div>`;
}

function row(playground: StepsTableStores, step: StepRow, seen: readonly Role[], guessing: boolean): TemplateResult {
  const { timeline } = playground;
  const current = step.step === timeline.step.value;
  return html`<tr aria-current=${current ? "step" : nothing} @click=${() => timeline.goTo(step.step)}>
    <th scope="row"><button type="button" class="link" aria-label="Step ${step.step}">${step.step}</button></th>
    ${guessing ? nothing : html`<td>${step.action === "" ? html`<span class="none">start</span>` : clipped(step.action)}</td>`}
    ${seen.map((role) => {
      const { symbol, states, goals } = step.observers[role];
      return html`<td class=${role}>${symbol === "" ? html`<span class="none">nothing yet</span>` : clipped(symbol)}</td>
        <td class="count">${states}</td>
        <td>${goals.length === 0 ? "none" : goals.length > MOST_NAMES ? `${goals.length} goals` : listed(goals)}</td>`;
    })}
    ${guessing ? nothing : html`<td class="count">${step.difference === null ? "" : differenceText(step.difference)}</td>`}
  </tr>`;
}

/** A long name is cut off for the eye alone. */
const clipped = (name: string): TemplateResult =>
  html`<span class="clipped" title=${named(name)}>${visible(name)}</span>`;

const listed = (names: readonly string[]) =>
  names.map((name, index) => html`${index === 0 ? nothing : ", "}${clipped(name)}`);

/** More would make rows that nobody reads; the boards and the file have them. */
const MOST_NAMES = 8;

function save({ timeline, gallery }: StepsTableStores): void {
  const trace = timeline.trace.value;
  if (trace === null) return;
  download(csv(trace), "text/csv", `${gallery.fileName.value}-steps.csv`);
}
