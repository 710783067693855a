// What plans can reach at all, in two pictures: the pairs of survivor counts, and the goal difference of each length.

import type { ReadonlySignal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import type { Gallery } from "../../gallery/gallery.js";
import type { Form } from "../../state/form.js";
import type { Pairs } from "../../state/pairs.js";
import { extras, type Lengths, type Tradeoff } from "../../state/tradeoff.js";
import { saveTable } from "../../view/save-table.js";
import { type ShownPlanStores, shownPlan } from "../shown-plan.js";
import { work } from "../work.js";
import { lengthsFile, pairsFile } from "./file.js";
import { type LengthPointStores, lengthPoints } from "./length-points.js";
import { lengthsChart } from "./lengths-chart.js";
import { type Bounds, type PairPointStores, pairPoints } from "./pair-points.js";
import { pairsChart } from "./pairs-chart.js";
import { lengthsTable, pairsTable } from "./tables.js";
import { lengthsInWords, pairsInWords } from "./words.js";

export interface TradeoffStores extends LengthPointStores, PairPointStores, ShownPlanStores {
  tradeoff: Tradeoff;
  gallery: Gallery;
  form: ReadonlySignal<Form>;
}

/** What is ready sooner needs no sign of work. */
const SLOW_S = 0.3;

export function tradeoff(playground: TradeoffStores): TemplateResult {
  const state = playground.tradeoff;
  const { pairs, lengths, busy, stopwatch, error, cut, replaced } = state;
  const slow = busy.value && stopwatch.seconds.value > SLOW_S;
  const old = !state.current.value && (slow || error.value !== null);
  return html`<div class="tradeoff">
    <div class="lead">
      <p>What plans can reach on this problem. Choose a point to see its plan on the boards.</p>
    <div role="alert">${
      error.value === null
        ? nothing
        : html`<p class="failed">${error.value} <button type="button" class="small" @click=${() => state.retry()}>Try again</button></p>`
    }</div>
    </div>
    ${
      slow
        ? html`<div class="at-work">${work(state.progress.value, stopwatch.seconds.value, "Looking at all plans")}
            <button type="button" @click=${() => state.cancel()}>Stop</button></div>`
        : nothing
    }
    <div class="charts" aria-busy=${String(busy.value)} data-old=${old || nothing} ?inert=${old}>
      ${pairs.value === null ? nothing : pairsPart(playground, pairs.value)}
      ${lengths.value === null ? nothing : lengthsPart(playground, lengths.value)}
    </div>
    <div role="status">${
      replaced.value
        ? html`<p class="cut">The solver did not stop when it was asked to; another took its place.</p>`
        : nothing
    }</div>
    ${
      cut.value && !busy.value
        ? html`<p class="cut">There are too many beliefs to look at every plan in so short a time.
            <button type="button" class="small" @click=${() => state.lookLonger()}>Look longer</button></p>`
        : nothing
    }
    ${legend} ${shownPlan(playground)}
  </div>`;
}

function pairsPart(playground: TradeoffStores, pairs: Pairs): TemplateResult {
  const goals = playground.boards.scene.value?.goals.length ?? 2;
  const bounds = boundsOf(playground);
  const points = pairPoints(playground, pairs.points, goals, bounds);
  return html`<figure>
    <figcaption><h3>Who is left in doubt</h3>
      <p>${pairsInWords(pairs, goals)}</p></figcaption>
    ${points.length === 0 ? nothing : html`${pairsChart(points, goals, bounds)} ${pairsTable(points)} ${saveTable("the pairs", pairsFile(pairs, goals, playground.gallery.fileName.value))}`}
  </figure>`;
}

function lengthsPart(playground: TradeoffStores, shown: Lengths): TemplateResult {
  const { points: lengths, bounds, complete } = shown;
  const points = lengthPoints(playground, lengths);
  const within = bounds.k === undefined && bounds.j === undefined ? "" : " within the bounds";
  return html`<figure>
    <figcaption><h3>What longer plans gain</h3>
      <p>${lengthsInWords(lengths, complete, within)}</p></figcaption>
    ${points.length === 0 ? nothing : lengthsChart(points, lengths)}
    ${extraField(playground)} ${
      lengths.length === 0
        ? nothing
        : html`${lengthsTable(points, lengths)} ${saveTable("the lengths", lengthsFile(shown, playground.gallery.fileName.value))}`
    }
  </figure>`;
}

function extraField({ tradeoff }: Pick<TradeoffStores, "tradeoff">): TemplateResult {
  const choose = (event: Event) => {
    tradeoff.extra.value = Number((event.target as HTMLSelectElement).value);
  };
  return html`<label class="extra">Up to
    <select @change=${choose}>${extras.map(
      (extra) => html`<option value=${extra} .selected=${extra === tradeoff.extra.value}>${extra}</option>`,
    )}</select> moves more than the shortest</label>`;
}

const legend = html`<ul class="chart-legend">
  <li><svg viewBox="0 0 24 24" aria-hidden="true"><circle class="dot best" cx="12" cy="12" r="8"></circle></svg>best</li>
  <li><svg viewBox="0 0 24 24" aria-hidden="true"><circle class="dot" cx="12" cy="12" r="5"></circle></svg>possible</li>
  <li><svg viewBox="0 0 24 24" aria-hidden="true"><circle class="dot outside" cx="12" cy="12" r="5"></circle></svg>outside the bounds k and j</li>
  <li><svg viewBox="0 0 24 24" aria-hidden="true"><circle class="dot" cx="12" cy="12" r="5"></circle><circle class="ring" cx="12" cy="12" r="10"></circle></svg>on the boards</li>
  <li><svg viewBox="0 0 24 24" aria-hidden="true"><path class="none" d="M7 7l10 10m0-10l-10 10"></path></svg>no plan of that length</li>
</ul>`;

function boundsOf(playground: TradeoffStores): Bounds {
  const { k, j } = playground.form.value;
  return { ...(k === "" ? {} : { k: Number(k) }), ...(j === "" ? {} : { j: Number(j) }) };
}
