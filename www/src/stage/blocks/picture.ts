// Towers of blocks on a table, and the hand above them.
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Towers } from "./towers.js";

/** Names are the document's and may be long; titles have them in full. */
const LONGEST_NAME = 3;
const GAP = 0.35;

/** `least`: the room there is in any case, and whether an empty hand is drawn. */
export function towersPicture(
  { towers, held, hand: known }: Towers,
  least: { columns: number; rows: number; hand: boolean },
): TemplateResult {
  const hand = known && (least.hand || held !== null);
  const width = Math.max(least.columns, towers.length) * (1 + GAP) + GAP;
  const rows = Math.max(least.rows, ...towers.map(({ blocks }) => blocks.length));
  const roof = hand ? 2.1 : 0.3;
  const floor = rows + roof;
  const left = (width - (towers.length * (1 + GAP) - GAP)) / 2;
  return html`<svg class="board towers" viewBox="0 0 ${width} ${floor + 0.25}">
    ${hand ? theHand(width / 2, held) : nothing}
    ${towers.map(({ blocks, grounded }, column) => {
      const x = left + column * (1 + GAP);
      return svg`${blocks.map((name, row) => block(name, x, floor - row - 1))}
        ${grounded ? nothing : svg`<path class="somewhere" d="M${x} ${floor + 0.06}h1"></path>`}`;
    })}
    ${towers.some(({ grounded }) => grounded) || known ? svg`<path class="table" d="M0.1 ${floor + 0.08}H${width - 0.1}"></path>` : nothing}
  </svg>`;
}

function block(name: string, x: number, y: number) {
  return svg`<g class="block"><title>${name}</title>
    <rect x=${x + 0.03} y=${y + 0.04} width="0.94" height="0.93" rx="0.12"></rect>
    <text x=${x + 0.5} y=${y + 0.66}>${shortened(name)}</text></g>`;
}

/** A gripper from above, open or around a block. */
function theHand(x: number, held: string | null) {
  const open = held === null ? 0.72 : 0.56;
  return svg`<path class="hand" d="M${x} 0.05v0.3M${x - open} 0.75v-0.4h${2 * open}v0.4"></path>
    ${held === null ? nothing : block(held, x - 0.5, 0.42)}`;
}

function shortened(name: string): string {
  const letters = [...name];
  return letters.length <= LONGEST_NAME ? name : `${letters.slice(0, LONGEST_NAME - 1).join("")}…`;
}
