// The signs on buttons and in the list of goals. They are drawn, not written: fonts differ.
import { html, svg, type TemplateResult } from "lit";
import { times } from "../problem/times.js";

export const icon = (shape: unknown, kind = ""): TemplateResult =>
  html`<svg class="icon ${kind}" viewBox="0 0 16 16" aria-hidden="true">${shape}</svg>`;

export const first = icon(svg`<path d="M3 3h2v10H3zM13 3v10L6 8z"></path>`);
export const back = icon(svg`<path d="M11 3v10L4 8z"></path>`);
export const play = icon(svg`<path d="M4 2.5v11L13 8z"></path>`);
export const pause = icon(svg`<path d="M4 3h3v10H4zM9 3h3v10H9z"></path>`);
export const forward = icon(svg`<path d="M5 3v10l7-5z"></path>`);
export const last = icon(svg`<path d="M11 3h2v10h-2zM3 3v10l7-5z"></path>`);

export const down = icon(svg`<path class="stroke" d="M4 6.5l4 4l4-4"></path>`);
export const left = icon(svg`<path class="stroke" d="M9.5 4l-4 4l4 4"></path>`);
export const right = icon(svg`<path class="stroke" d="M6.5 4l4 4l-4 4"></path>`);
export const cross = icon(svg`<path class="cross" d="M4 4l8 8M12 4l-8 8"></path>`);
export const chain = icon(
  svg`<path class="stroke" d="M6.8 9.2a2.6 2.6 0 0 0 3.7 0l2.4-2.4a2.6 2.6 0 0 0-3.7-3.7l-1 1M9.2 6.8a2.6 2.6 0 0 0-3.7 0L3.1 9.2a2.6 2.6 0 0 0 3.7 3.7l1-1"></path>`,
);
export const frame = icon(
  svg`<path class="stroke" d="M2 3.5h12v9H2zM2.5 12l3.8-4.2l2.6 2.8l1.8-1.8l3 3.2"></path><circle cx="10.6" cy="6.3" r="1"></circle>`,
);
export const tick = icon(svg`<path class="stroke" d="M3 8.5l3.5 3.5L13 4.5"></path>`);
export const question = icon(
  svg`<path class="stroke" d="M5.4 6a2.6 2.6 0 1 1 3.9 2.2c-.9.5-1.3 1-1.3 2"></path><circle cx="8" cy="12.8" r="0.9"></circle>`,
);

/** A five-pointed star around the origin, one unit to each point. */
export const starPath = `M${times(10, (corner) => {
  const [angle, radius] = [(corner * Math.PI) / 5, corner % 2 === 0 ? 1 : 0.45];
  return `${(radius * Math.sin(angle)).toFixed(3)} ${(-radius * Math.cos(angle)).toFixed(3)}`;
}).join("L")}Z`;

export const star = html`<svg class="icon star" viewBox="-1.1 -1.1 2.2 2.2" aria-hidden="true">${svg`<path d=${starPath}></path>`}</svg>`;
export const possible = icon(svg`<circle cx="8" cy="8" r="5.5"></circle>`);
/** Not possible now, and not ruled out. */
export const notNow = icon(svg`<circle class="stroke" cx="8" cy="8" r="4.7"></circle>`);
export const ruledOut = icon(svg`<path class="cross" d="M4 4l8 8M12 4l-8 8"></path>`);

const eye = svg`<path class="line" d="M1 8s2.6-4.4 7-4.4S15 8 15 8s-2.6 4.4-7 4.4S1 8 1 8z"></path>`;
/** An eye with a diamond in it: the enemy's mark on the boards. */
export const enemyEye = icon(svg`${eye}<path d="M8 5.2L10.8 8L8 10.8L5.2 8z"></path>`, "eye");
/** An eye with a disc in it: the friend's mark on the boards. */
export const friendEye = icon(svg`${eye}<circle cx="8" cy="8" r="2.5"></circle>`, "eye");
export const agentFace = icon(svg`<circle cx="8" cy="8" r="5"></circle>`);
