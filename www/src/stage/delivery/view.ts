// A delivery: packages of factories, a truck and the delivery area.
import { svg, type TemplateResult } from "lit";
import { goalSigns, type Sign, signList, trueGoal } from "../signs.js";
import type { View } from "../view.js";
import { deliveryBoard } from "./board.js";
import type { DeliveryScene } from "./facts.js";
import { shelfPackage } from "./package.js";

export const deliveryView = (scene: DeliveryScene): View => ({
  board: (name, input) => deliveryBoard(name, { ...input, scene }),
  legend: () => signs,
});

const parcel = (share: number, meaning: string): Sign => [
  svg`<g transform="translate(0.07 0.07) scale(0.86)">${shelfPackage("", { x: 0, y: 0 }, share, false)}</g>`,
  meaning,
];

const signs: TemplateResult = signList([
  parcel(0, "package at its factory"),
  parcel(1, "surely in the truck"),
  parcel(0.5, "perhaps in the truck"),
  trueGoal,
  ...goalSigns,
]);
