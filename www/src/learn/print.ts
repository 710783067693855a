// In print a figure that nothing has been done with shows its end, which is what the text speaks of. One that the print
// itself has loaded goes there as soon as it runs; until then its poster shows the same.
import type { StepDetail } from "../element/events.js";
import type { MoCoppPlayground } from "../element/mo-copp-playground.js";

/** Beyond every last step. */
const END = 10_000;

export function printEnds(figures: Iterable<MoCoppPlayground>): void {
  const all = [...figures];
  const moved = new Set<MoCoppPlayground>();
  let printing = false;
  const toEnd = (figure: MoCoppPlayground) => {
    if (!printing || figure.dataset.step !== "0") return;
    moved.add(figure);
    void figure.goTo(END);
  };
  for (const figure of all)
    figure.addEventListener("mo-copp-step", (event) => {
      // Before there is a plan the start is all there is.
      if ((event as CustomEvent<StepDetail>).detail.steps > 0) toEnd(figure);
    });
  addEventListener("beforeprint", () => {
    printing = true;
    for (const figure of all) toEnd(figure);
  });
  addEventListener("afterprint", () => {
    printing = false;
    for (const figure of moved) void figure.goTo(0);
    moved.clear();
  });
}
