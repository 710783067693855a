// The picture of a delivery, after Figure 1 of the paper: the factories with their packages, the truck, the delivery
// area, and the candidate goals. On an observer's board each package is as sure as that observer is of it.
import { html, svg, type TemplateResult } from "lit";
import { called } from "../../view/observers.js";
import type { BoardName } from "../board-input.js";
import { type DeliveryInput, isLoaded, loadedShares, packagesOf } from "./facts.js";
import { cardsOf, goalCards } from "./goals.js";
import { AREA, layoutOf, ROAD, WIDTH } from "./layout.js";
import { shelfPackage, shortened } from "./package.js";
import { truck } from "./truck.js";

/** A longer name would run into the roof. */
const LONGEST_FACTORY = 7;

export function deliveryBoard(name: BoardName, input: DeliveryInput): TemplateResult {
  const layout = layoutOf(input.scene);
  const cards = cardsOf(input);
  const shares = loadedShares(input.scene, name === "actor" ? [input.shown.state] : input.shown.beliefs[name]);
  const top = layout.height + 0.55;
  const box = `-0.1 -0.1 ${WIDTH + 0.2} ${top + cards.height}`;
  return html`<svg class="board delivery" data-board=${name} viewBox=${box} role="img" aria-label=${described(name, input)}>
    <path class="road" d="M${ROAD - 0.3} ${layout.height / 2}H${AREA}"></path>
    <rect class="area" x=${AREA} y="0.1" width=${WIDTH - AREA - 0.1} height=${layout.height - 0.2} rx="0.3"></rect>
    <text class="place" x=${(AREA + WIDTH) / 2 - 0.05} y="0.7">delivery area</text>
    ${layout.factories.map(
      ({ x, y, width, height, name: factory, packages }) => svg`<g class="factory">
        <path class="walls" d="M${x} ${y + height}V${y + 0.45}l0.6 -0.35v0.35l0.6 -0.35v0.35l0.6 -0.35v0.35H${x + width}V${y + height}z"></path>
        <title>Factory ${factory}</title>
        <text class="place" x=${x + width - 0.25} y=${y + 0.3}>${shortened(factory, LONGEST_FACTORY)}</text>
        ${packages.map((spot) => shelfPackage(spot.name, spot, shares.get(spot.name) ?? 0, name === "actor"))}
      </g>`,
    )}
    ${truck(name, input, layout)} ${goalCards(name, input, cards, top)}
  </svg>`;
}

function described(name: BoardName, input: DeliveryInput): string {
  const { scene, shown, step } = input;
  const packages = packagesOf(scene);
  if (name === "actor") {
    const loaded = packages.filter((pack) => isLoaded(shown.state, pack));
    return `The truck after ${step} actions, with ${loaded.length === 0 ? "nothing" : loaded.join(" and ")} in it.`;
  }
  const shares = loadedShares(scene, shown.beliefs[name]);
  const sure = packages.filter((pack) => shares.get(pack) === 1);
  const perhaps = packages.filter((pack) => (shares.get(pack) ?? 0) > 0 && (shares.get(pack) ?? 0) < 1);
  const listed = (names: string[]) => (names.length === 0 ? "none" : names.join(", "));
  return `After ${step} actions the ${called[name]} is sure to see in the truck: ${listed(sure)}; perhaps in it: ${listed(perhaps)}.`;
}
