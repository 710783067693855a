// Driving a run of the core slice by slice.
import type { Progress } from "../core.js";
import { firstBudget, nextBudget } from "./budget.js";
import { nextTurn } from "./turn.js";

/** More often would only be flicker. */
const REPORT_MS = 100;

/** The part of the core's run that is needed here. */
export interface Sliced {
  advance(budget: number): boolean;
  progress(): Progress;
}

/** Advances the run until it is finished or `stop` says so, reporting now and then. */
export async function inSlices(run: Sliced, stop: () => boolean, report: (progress: Progress) => void): Promise<void> {
  let budget = firstBudget;
  let reported = performance.now();
  while (!stop()) {
    const started = performance.now();
    if (run.advance(budget)) return;
    const ended = performance.now();
    budget = nextBudget(budget, ended - started);
    if (ended - reported >= REPORT_MS) {
      reported = ended;
      report(run.progress());
    }
    await nextTurn();
  }
}
