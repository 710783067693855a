// Things of the recycling robot, each drawn around the origin.
import { svg } from "lit";

export const can = (look: "sure" | "perhaps") =>
  svg`<g class="can ${look}"><path d="M-0.09 -0.15h0.18v0.3h-0.18z"></path><path class="lid" d="M-0.09 -0.08h0.18M-0.09 0.08h0.18"></path></g>`;

/** Behind the goal's badge: its lid and its foot are seen. */
export const bin = () =>
  svg`<path class="bin" d="M-0.36 -0.36h0.72M-0.12 -0.42h0.24M-0.31 -0.36l0.06 0.78h0.5l0.06 -0.78"></path>`;

export const charger = () =>
  svg`<g class="charger"><rect x="-0.42" y="-0.42" width="0.84" height="0.84" rx="0.14"></rect><path d="M0.06 -0.34L-0.2 0.06h0.16l-0.06 0.3L0.2 -0.08h-0.18z"></path></g>`;
