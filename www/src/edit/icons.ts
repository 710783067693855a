// The signs of the tools.
import { html, type SVGTemplateResult, svg, type TemplateResult } from "lit";

const icon = (shape: SVGTemplateResult): TemplateResult =>
  html`<svg class="icon tool-icon" viewBox="0 0 16 16" aria-hidden="true">${shape}</svg>`;

const arrow = "M3 8V4.5M3 4.5H6.5M3 4.5L7 8.2A4.3 4.3 0 1 1 7.2 13.2";

export const tools = {
  move: icon(
    svg`<path class="line" d="M8 1.5v13M1.5 8h13M6 3.5l2-2l2 2M6 12.5l2 2l2-2M3.5 6l-2 2l2 2M12.5 6l2 2l-2 2"></path>`,
  ),
  walls: icon(svg`<path d="M1.5 3h6v4h-6zM8.5 3h6v4h-6zM4.5 9h7v4h-7zM1.5 9h2v4h-2zM12.5 9h2v4h-2z"></path>`),
  belief: icon(
    svg`<rect class="line" x="2" y="2" width="12" height="12" rx="2.5"></rect><circle cx="8" cy="8" r="2.4"></circle>`,
  ),
  cameras: icon(
    svg`<path class="line" d="M2 5.5v-3.5h3.5M10.5 2h3.5v3.5M14 10.5v3.5h-3.5M5.5 14h-3.5v-3.5"></path><circle cx="8" cy="8" r="2"></circle>`,
  ),
  undo: icon(svg`<path class="line" d=${arrow}></path>`),
  redo: icon(svg`<path class="line" transform="matrix(-1 0 0 1 16 0)" d=${arrow}></path>`),
  reset: icon(svg`<path class="line" d="M3.2 5.4A5.6 5.6 0 1 1 2.4 8.6M3 2v3.6h3.6"></path>`),
};

export const cross = icon(svg`<path class="line" d="M4 4l8 8M12 4l-8 8"></path>`);
