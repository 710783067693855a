// One step as a row of words and numbers, for the table and for the file.
import type { Trace } from "../core.js";
import { stateCount } from "../stage/belief-size.js";
import type { Mode } from "../state/boards.js";
import { type Role, roles } from "../view/observers.js";

export interface StepRow {
  step: number;
  action: string;
  observers: Record<Role, { symbol: string; states: number; goals: readonly string[] }>;
  /** At the end of a plan for the true goal; null at all other steps, where no plan ends. */
  difference: number | null;
}

export function stepRows({ steps, valid }: Trace): StepRow[] {
  return steps.map((shown, step) => stepRow(shown, step, valid && step === steps.length - 1));
}

function stepRow(shown: Trace["steps"][number], step: number, ends: boolean): StepRow {
  const seen = (role: Role) => ({
    symbol: shown.symbols[role] ?? "",
    states: stateCount(shown, role),
    goals: shown.goals[role],
  });
  return {
    step,
    action: shown.action ?? "",
    observers: { adversarial: seen("adversarial"), cooperative: seen("cooperative") },
    difference: ends ? shown.goal_difference : null,
  };
}

/** Who plays the enemy sees the enemy's columns alone. */
export const rolesSeen = (mode: Mode): readonly Role[] => (mode === "guess" ? ["adversarial"] : roles);
