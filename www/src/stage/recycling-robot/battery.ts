// The battery below a board: how full it is, or how full an observer holds possible.
import { nothing, svg } from "lit";
import { times } from "../../problem/times.js";
import { can } from "./things.js";

/** The document allows many levels; more than these are a number. */
const MOST = 12;

/**
 * `carried`: an observer takes the can to be in the gripper, or holds that possible.
 *
 * `width`: the room there is, in cells. `exact`: the level is known, and what is below it is full too.
 */
export function battery(
  levels: readonly (string | number)[],
  count: number,
  width: number,
  exact: boolean,
  carried: "sure" | "perhaps" | null,
) {
  const known = levels.map(Number).sort((a, b) => a - b);
  const low = known[0] ?? 0;
  const high = known.at(-1) ?? 0;
  const room = width * 0.4;
  const cells = Math.max(1, count - 1);
  const each = Math.min(0.26, room / cells);
  const look = (level: number) => (exact ? (level <= high ? "full" : "") : known.includes(level) ? "full" : "");
  const said = low === high ? String(low) : `${low}–${high}`;
  return svg`<g class="battery"><title>battery level ${said} of ${count - 1}</title>
    ${
      cells > MOST
        ? nothing
        : svg`<g transform="translate(0.06 0.18)"><rect class="case" width=${each * cells + 0.08} height="0.44" rx="0.07"></rect>
            <rect class="case" x=${each * cells + 0.08} y="0.12" width="0.07" height="0.2"></rect>
            ${times(cells, (index) => svg`<rect class="level ${look(index + 1)}" x=${0.06 + index * each} y="0.06" width=${each - 0.04} height="0.32" rx="0.03"></rect>`)}</g>`
    }
    <text class="below" x=${cells > MOST ? 0.06 : each * cells + 0.32} y="0.52">${said}</text>
    ${carried === null ? nothing : svg`<g transform="translate(${width - 0.2} 0.4) scale(1.3)">${can(carried)}</g><text class="below end" x=${width - 0.42} y="0.52">${carried === "sure" ? "holds" : "may hold"}</text>`}
  </g>`;
}
