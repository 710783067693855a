// Where things stand in the picture of a delivery. One unit is a package.
import type { DeliveryScene } from "./facts.js";

export const WIDTH = 13;
/** Packages side by side in a factory. */
const IN_A_ROW = 4;
/** Packages side by side in the truck. */
const IN_THE_BED = 4;
const ROOF = 0.75;
const GAP = 0.35;
/** Where the road begins, and the delivery area. */
export const ROAD = 5.6;
export const AREA = 8.7;

export interface Spot {
  x: number;
  y: number;
}

export interface FactoryBox extends Spot {
  name: string;
  width: number;
  height: number;
  packages: (Spot & { name: string })[];
}

export interface Layout {
  factories: FactoryBox[];
  /** The height of the factories together, which is the road's too. */
  height: number;
}

export function layoutOf(scene: DeliveryScene): Layout {
  let y = 0.1;
  const factories = scene.factories.map(({ name, packages }) => {
    const rows = Math.max(1, Math.ceil(packages.length / IN_A_ROW));
    const box: FactoryBox = {
      ...{ name, x: 0.1, y, width: ROAD - 0.6, height: ROOF + rows * 1.15 + 0.15 },
      packages: packages.map((pack, index) => ({
        name: pack,
        x: 0.3 + (index % IN_A_ROW) * 1.17,
        y: y + ROOF + Math.floor(index / IN_A_ROW) * 1.15 + 0.1,
      })),
    };
    y += box.height + GAP;
    return box;
  });
  return { factories, height: Math.max(y - GAP + 0.1, 3.6) };
}

export const bedRows = (room: number): number => Math.ceil(room / IN_THE_BED);

/** The place of the package loaded as number `index`, seen from the bed's corner. */
export const inBed = (index: number): Spot => ({
  x: (index % IN_THE_BED) * 0.62,
  y: -Math.floor(index / IN_THE_BED) * 0.62,
});

export const bedWidth = (room: number): number => Math.min(room, IN_THE_BED) * 0.62 + 0.12;
