// What the signs on the boards mean.
import { svg, type TemplateResult } from "lit";
import type { Boards } from "../state/boards.js";
import { isGrid } from "./grid/cells.js";
import { viewOf } from "./lazy-views.js";
import { goalSigns, signList, trueGoal } from "./signs.js";

interface LegendStores {
  boards: Boards;
}

/** Only boards that are drawn need one. */
export function legend(playground: LegendStores): TemplateResult | "" {
  const scene = playground.boards.scene.value;
  if (scene === null) return "";
  return isGrid(scene) ? signs : (viewOf(scene)?.legend?.() ?? "");
}

const tile = svg`<rect class="believed" x="0.05" y="0.05" width="0.9" height="0.9" rx="0.15"></rect>
  <circle class="dot" cx="0.5" cy="0.5" r="0.13"></circle>`;

const signs: TemplateResult = signList([
  [svg`<circle class="here" cx="0.5" cy="0.5" r="0.32"></circle>`, "agent"],
  trueGoal,
  [svg`<circle class="start" cx="0.5" cy="0.5" r="0.3"></circle>`, "start"],
  [tile, "the agent may be here"],
  [svg`<circle class="hidden-here" cx="0.5" cy="0.5" r="0.4"></circle>`, "where it really is"],
  ...goalSigns,
]);
