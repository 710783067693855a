// The truck: where it is, and what lies in its bed. To an observer each thing in it is what it was told.
import { nothing, svg } from "lit";
import type { BoardName } from "../board-input.js";
import { type DeliveryInput, isLoaded, truckPlace } from "./facts.js";
import { AREA, bedRows, bedWidth, inBed, type Layout, ROAD } from "./layout.js";
import { smallPackage } from "./package.js";

export function truck(name: BoardName, input: DeliveryInput, layout: Layout) {
  const { scene, shown } = input;
  const place = truckPlace(scene, shown.state);
  // An observer that can't tell where the truck is sees it on the road; that it delivered, it was told.
  const known = name === "actor" || place === "yard" || place === "delivery area" ? place : agreed(name, input);
  const room = scene.deliver;
  const width = bedWidth(room);
  const high = bedRows(room) * 0.62;
  const factory = typeof known === "number" ? layout.factories[known] : undefined;
  // A long truck on the road keeps out of the delivery area.
  const onRoad = Math.min(ROAD + 0.55, AREA - width - 1.1);
  const x = known === "delivery area" ? AREA + 0.45 : factory === undefined ? onRoad : ROAD - 0.15;
  const y = factory === undefined ? layout.height / 2 + high / 2 : factory.y + factory.height / 2 + high / 2 + 0.2;
  const floor = Math.min(layout.height - 0.45, Math.max(high + 0.5, y));
  return svg`<g class="truck" transform="translate(${x} ${floor})">
    <title>${titles[typeof known === "number" ? "factory" : known]}${factory === undefined ? "" : factory.name}</title>
    ${cargo(name, input).map(({ label, title, kind }, index) => {
      const spot = inBed(index);
      return smallPackage(label, title, { x: spot.x + 0.08, y: spot.y - 0.68 }, 0.56, kind);
    })}
    <path class="bed" d="M0 ${-high - 0.1}V0H${width + 0.85}V-0.55l-0.3 -0.45h-0.5V0M${width} 0V${-high - 0.1}"></path>
    <circle class="wheel" cx="0.35" cy="0.08" r="0.22"></circle>
    <circle class="wheel" cx=${width + 0.45} cy="0.08" r="0.22"></circle>
    ${typeof known !== "number" && known === "unknown" ? svg`<text class="where" x=${width / 2} y=${-high - 0.35}>?</text>` : nothing}
  </g>`;
}

const titles = {
  yard: "The truck waits in the yard",
  "delivery area": "The truck is at the delivery area",
  factory: "The truck is at ",
  unknown: "The truck is at a factory; the observer can't tell which",
};

/** The factory at which all believed states have the truck. */
function agreed(name: Exclude<BoardName, "actor">, { scene, shown }: DeliveryInput): number | "unknown" {
  const places = new Set(shown.beliefs[name].map((state) => truckPlace(scene, state)));
  const [place] = places;
  return places.size === 1 && typeof place === "number" ? place : "unknown";
}

/** What lies in the bed, in the order in which it was loaded. */
function cargo(name: BoardName, { scene, trace, step, shown }: DeliveryInput) {
  const goods: { label: string; title: string; kind: string }[] = [];
  let before = trace.steps[0];
  for (const now of trace.steps.slice(0, step + 1)) {
    const earlier = before ?? now;
    before = now;
    const added = scene.factories
      .flatMap(({ packages }) => packages)
      .find((pack) => isLoaded(now.state, pack) && !isLoaded(earlier.state, pack));
    if (added === undefined) continue;
    if (name === "actor") {
      goods.push({ label: added, title: added, kind: "solid" });
    } else {
      const symbol = now.symbols[name] ?? "";
      const sure = shown.beliefs[name].every((state) => isLoaded(state, added));
      goods.push({ label: mark(symbol), title: `Told: ${symbol}`, kind: sure ? "seen sure" : "seen" });
    }
  }
  return goods;
}

/** A symbol's last word where it is short ("barcode A" is "A"); else a question mark. */
function mark(symbol: string): string {
  const word = symbol.split(" ").at(-1) ?? "";
  return [...word].length <= 2 ? word : "?";
}
