// Signs that the legends of several kinds of boards explain.
import { html, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import { starPath } from "../view/icons.js";

const sample = ([mark, meaning]: Sign) =>
  html`<li><svg class="board" viewBox="0 0 1 1" aria-hidden="true">${mark}</svg>${meaning}</li>`;

/** A sign and what it means. */
export type Sign = readonly [mark: SVGTemplateResult, meaning: string];

export const trueGoal: Sign = [
  svg`<path class="star" transform="translate(0.5 0.54) scale(0.48)" d=${starPath}></path>`,
  "true goal",
];

const badge = svg`<rect class="badge" x="0.08" y="0.18" width="0.84" height="0.64" rx="0.18"></rect>`;
const strike = svg`<line class="strike" x1="0.08" y1="0.82" x2="0.92" y2="0.18"></line>`;

/** What a goal is at a step. */
export const goalSigns: readonly Sign[] = [
  [
    svg`<path class="mark enemy on" d="M0.5 0.12l0.38 0.38l-0.38 0.38l-0.38-0.38z"></path>`,
    "goal possible for the enemy",
  ],
  [svg`<circle class="mark friend on" cx="0.5" cy="0.5" r="0.34"></circle>`, "goal possible for the friend"],
  [svg`<g class="goal open">${badge}</g>`, "goal not possible now"],
  [svg`<g class="goal dead">${badge}${strike}</g>`, "goal ruled out"],
];

export const signList = (signs: readonly Sign[]): TemplateResult =>
  html`<ul class="legend" part="legend" aria-label="What the signs mean">${signs.map(sample)}</ul>`;
