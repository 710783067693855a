// Whether two documents are the same problem, however they are written down.
import type { ProblemDocument } from "./types.js";

export function sameProblem(one: ProblemDocument, other: ProblemDocument): boolean {
  return one === other || (sameAtAGlance(one, other) && canonical(one, "") === canonical(other, ""));
}

/** Most problems differ here: that is seen without reading all of a large one. */
function sameAtAGlance(one: ProblemDocument, other: ProblemDocument): boolean {
  if (one.format !== other.format) return false;
  if (one.format !== "gridworld" || other.format !== "gridworld") return true;
  return one.width === other.width && one.height === other.height && String(one.start) === String(other.start);
}

/** Lists of cells that are sets: their order means nothing. */
const sets = new Set(["walls", "cameras", "initial_belief"]);

/** Keys in one order, sets sorted, and nothing written down that is so anyway. */
function canonical(value: unknown, key: string): string {
  if (Array.isArray(value)) {
    const entries = value.map((entry) => canonical(entry, ""));
    return `[${(sets.has(key) ? entries.sort() : entries).join()}]`;
  }
  if (typeof value !== "object" || value === null) return JSON.stringify(value) ?? "";
  const entries = Object.entries(value).filter(([name, entry]) => !isDefault(name, entry));
  entries.sort(([a], [b]) => (a < b ? -1 : 1));
  return `{${entries.map(([name, entry]) => `${JSON.stringify(name)}:${canonical(entry, name)}`).join()}}`;
}

const isDefault = (name: string, value: unknown): boolean =>
  value === undefined ||
  (name === "stay" && value === false) ||
  ((name === "walls" || name === "cameras") && Array.isArray(value) && value.length === 0);
