// A package: at its factory, in the truck, or in a goal.
import { nothing, svg } from "lit";
import type { Spot } from "./layout.js";

const LONGEST = 3;

/** `share`: in how much of the belief it is in the truck, which fills the box from below; the agent's board knows. */
export function shelfPackage(name: string, { x, y }: Spot, share: number, known: boolean) {
  const kind = share === 1 ? "gone" : share > 0 ? "perhaps" : "solid";
  const meaning = known
    ? share === 1
      ? "in the truck"
      : "at the factory"
    : share === 1
      ? "surely in the truck"
      : share > 0
        ? `perhaps in the truck (in ${Math.round(share * 100)} % of the believed states)`
        : "surely still here";
  return svg`<g class="package ${kind}" transform="translate(${x} ${y})">
    <title>${name}: ${meaning}</title>
    <rect class="box" width="1" height="1" rx="0.12"></rect>
    ${share > 0 && share < 1 ? svg`<rect class="share" y=${1 - share} width="1" height=${share} rx="0.12"></rect>` : nothing}
    <path class="tape" d="M0 0.3h1"></path>
    ${label(name)}
    ${share > 0 && share < 1 ? svg`<text class="doubt" x="0.85" y="0.24">?</text>` : nothing}
  </g>`;
}

/** A small one, `size` wide, with what is known of it. */
export function smallPackage(name: string, title: string, { x, y }: Spot, size: number, kind: string) {
  return svg`<g class="package ${kind}" transform="translate(${x} ${y}) scale(${size})">
    <title>${title}</title>
    <rect class="box" width="1" height="1" rx="0.12"></rect>
    <path class="tape" d="M0 0.3h1"></path>
    ${label(name)}
  </g>`;
}

function label(name: string) {
  const text = shortened(name, LONGEST);
  return svg`<text class=${[...text].length > 2 ? "long" : ""} x="0.5" y="0.78">${text}</text>`;
}

export function shortened(name: string, longest: number): string {
  const letters = [...name];
  return letters.length <= longest ? name : `${letters.slice(0, longest - 1).join("")}…`;
}
