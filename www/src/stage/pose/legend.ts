// What the signs on the boards with a robot mean.
import { html, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import { starPath } from "../../view/icons.js";
import { robot } from "./robot.js";

const sample = ([mark, meaning]: readonly [SVGTemplateResult, string]) =>
  html`<li><svg class="board pose" viewBox="0 0 1 1" aria-hidden="true">${mark}</svg>${meaning}</li>`;

const badge = svg`<rect class="badge" x="0.08" y="0.18" width="0.84" height="0.64" rx="0.18"></rect>`;

/** The signs of every such board, and those that the domain adds. */
export const poseSigns = (more: readonly (readonly [SVGTemplateResult, string])[]): TemplateResult =>
  html`<ul class="legend" part="legend" aria-label="What the signs mean">
    ${[
      [svg`${robot("actor", [0, 0], 1.6, false, null)}`, "robot"] as const,
      ...more,
      [svg`<path class="star" transform="translate(0.5 0.54) scale(0.48)" d=${starPath}></path>`, "true goal"] as const,
      [
        svg`<rect class="believed" x="0.05" y="0.05" width="0.9" height="0.9" rx="0.15"></rect><circle class="dot" cx="0.5" cy="0.5" r="0.13"></circle>`,
        "the robot may be here",
      ] as const,
      [svg`${robot("adversarial", [0, 0], 1.6, false, null)}`, "where it really is"] as const,
      [
        svg`<path class="mark enemy on" d="M0.5 0.12l0.38 0.38l-0.38 0.38l-0.38-0.38z"></path>`,
        "goal possible for the enemy",
      ] as const,
      [
        svg`<circle class="mark friend on" cx="0.5" cy="0.5" r="0.34"></circle>`,
        "goal possible for the friend",
      ] as const,
      [svg`<g class="goal open">${badge}</g>`, "goal not possible now"] as const,
      [
        svg`<g class="goal dead">${badge}<line class="strike" x1="0.08" y1="0.82" x2="0.92" y2="0.18"></line></g>`,
        "goal ruled out",
      ] as const,
    ].map(sample)}
  </ul>`;
