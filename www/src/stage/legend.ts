// What the signs on the boards mean.
import { html, type SVGTemplateResult, svg, type TemplateResult } from "lit";
import type { Boards } from "../state/boards.js";
import { starPath } from "../view/icons.js";
import { isDelivery } from "./delivery/facts.js";
import { shelfPackage } from "./delivery/package.js";
import { isGrid } from "./grid/cells.js";
import { viewOf } from "./lazy-views.js";

interface LegendStores {
  boards: Boards;
}

const sample = (mark: SVGTemplateResult, meaning: string) =>
  html`<li><svg class="board" viewBox="0 0 1 1" aria-hidden="true">${mark}</svg>${meaning}</li>`;

const tile = svg`<rect class="believed" x="0.05" y="0.05" width="0.9" height="0.9" rx="0.15"></rect>
  <circle class="dot" cx="0.5" cy="0.5" r="0.13"></circle>`;
const badge = svg`<rect class="badge" x="0.08" y="0.18" width="0.84" height="0.64" rx="0.18"></rect>`;
const strike = svg`<line class="strike" x1="0.08" y1="0.82" x2="0.92" y2="0.18"></line>`;

/** Only boards that are drawn need one. */
export function legend(playground: LegendStores): TemplateResult | "" {
  const scene = playground.boards.scene.value;
  if (scene === null) return "";
  if (isDelivery(scene)) return deliverySigns;
  return isGrid(scene) ? signs : (viewOf(scene)?.legend?.() ?? "");
}

const enemysMark = svg`<path class="mark enemy on" d="M0.5 0.12l0.38 0.38l-0.38 0.38l-0.38-0.38z"></path>`;
const friendsMark = svg`<circle class="mark friend on" cx="0.5" cy="0.5" r="0.34"></circle>`;
const trueGoal = svg`<path class="star" transform="translate(0.5 0.54) scale(0.48)" d=${starPath}></path>`;

const signs: TemplateResult = html`<ul class="legend" part="legend" aria-label="What the signs mean">
  ${sample(svg`<circle class="here" cx="0.5" cy="0.5" r="0.32"></circle>`, "agent")}
  ${sample(trueGoal, "true goal")}
  ${sample(svg`<circle class="start" cx="0.5" cy="0.5" r="0.3"></circle>`, "start")}
  ${sample(tile, "the agent may be here")}
  ${sample(svg`<circle class="hidden-here" cx="0.5" cy="0.5" r="0.4"></circle>`, "where it really is")}
  ${sample(enemysMark, "goal possible for the enemy")}
  ${sample(friendsMark, "goal possible for the friend")}
  ${sample(svg`<g class="goal open">${badge}</g>`, "goal not possible now")}
  ${sample(svg`<g class="goal dead">${badge}${strike}</g>`, "goal ruled out")}
</ul>`;

const parcel = (share: number) =>
  svg`<g transform="translate(0.07 0.07) scale(0.86)">${shelfPackage("", { x: 0, y: 0 }, share, false)}</g>`;

const deliverySigns: TemplateResult = html`<ul class="legend" part="legend" aria-label="What the signs mean">
  ${sample(parcel(0), "package at its factory")}
  ${sample(parcel(1), "surely in the truck")}
  ${sample(parcel(0.5), "perhaps in the truck")}
  ${sample(trueGoal, "true goal")}
  ${sample(enemysMark, "goal possible for the enemy")}
  ${sample(friendsMark, "goal possible for the friend")}
  ${sample(svg`<g class="goal open">${badge}</g>`, "goal not possible now")}
  ${sample(svg`<g class="goal dead">${badge}${strike}</g>`, "goal ruled out")}
</ul>`;
