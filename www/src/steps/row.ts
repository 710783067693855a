// One step as a row of words and numbers, for the table and for the file.
import type { TraceStep } from "../core.js";
import { stateCount } from "../stage/belief-size.js";
import type { Mode } from "../state/boards.js";
import { type Role, roles } from "../view/observers.js";

export interface StepRow {
  step: number;
  action: string;
  observers: Record<Role, { symbol: string; states: number; goals: readonly string[] }>;
  difference: number;
}

export function stepRow(shown: TraceStep, step: number): StepRow {
  const seen = (role: Role) => ({
    symbol: shown.symbols[role] ?? "",
    states: stateCount(shown, role),
    goals: shown.goals[role],
  });
  return {
    step,
    action: shown.action ?? "",
    observers: { adversarial: seen("adversarial"), cooperative: seen("cooperative") },
    difference: shown.goal_difference,
  };
}

/** Who plays the enemy sees the enemy's columns alone. */
export const rolesSeen = (mode: Mode): readonly Role[] => (mode === "guess" ? ["adversarial"] : roles);
