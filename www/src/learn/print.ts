// In print a figure that nothing has been done with shows its end, which is what the text speaks of.
import type { MoCoppPlayground } from "../element/mo-copp-playground.js";

/** Beyond every last step. */
const END = 10_000;

export function printEnds(figures: Iterable<MoCoppPlayground>): void {
  let moved: MoCoppPlayground[] = [];
  addEventListener("beforeprint", () => {
    moved = [...figures].filter(({ dataset }) => dataset.step === "0");
    for (const figure of moved) void figure.goTo(END);
  });
  addEventListener("afterprint", () => {
    for (const figure of moved) void figure.goTo(0);
  });
}
