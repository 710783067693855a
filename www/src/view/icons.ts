// The signs on buttons and in the list of goals. They are drawn, not written: fonts differ.
import { html, svg, type TemplateResult } from "lit";
import { starPath } from "./board-goal.js";

const icon = (shape: unknown): TemplateResult =>
  html`<svg class="icon" viewBox="0 0 16 16" aria-hidden="true">${shape}</svg>`;

export const first = icon(svg`<path d="M3 3h2v10H3zM13 3v10L6 8z"></path>`);
export const back = icon(svg`<path d="M11 3v10L4 8z"></path>`);
export const play = icon(svg`<path d="M4 2.5v11L13 8z"></path>`);
export const pause = icon(svg`<path d="M4 3h3v10H4zM9 3h3v10H9z"></path>`);
export const forward = icon(svg`<path d="M5 3v10l7-5z"></path>`);
export const last = icon(svg`<path d="M11 3h2v10h-2zM3 3v10l7-5z"></path>`);

export const star = html`<svg class="icon star" viewBox="-1.1 -1.1 2.2 2.2" aria-hidden="true">${svg`<path d=${starPath}></path>`}</svg>`;
export const possible = icon(svg`<circle cx="8" cy="8" r="5.5"></circle>`);
export const ruledOut = icon(svg`<path class="cross" d="M4 4l8 8M12 4l-8 8"></path>`);
