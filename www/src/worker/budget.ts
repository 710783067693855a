// How much work one slice gets, in the solver's own unit (expansions or nodes).
// The clock only sizes slices; it decides nothing that is reported.

/** Long enough to keep the overhead small, short enough that a cancel is taken at once. */
const SLICE_MS = 20;
const LARGEST = 1_000_000;
/** One slice's time says little: change by no more than this factor at once. */
const STEP = 4;

/** Small, since one node of a large integer program can take seconds. */
export const firstBudget = 1;

/** The next slice's budget, after a slice of `budget` took `milliseconds`. */
export function nextBudget(budget: number, milliseconds: number): number {
  const factor = SLICE_MS / Math.max(milliseconds, SLICE_MS / STEP);
  return Math.min(LARGEST, Math.max(1, Math.round(budget * Math.max(factor, 1 / STEP))));
}
