// The steps as a table for a spreadsheet.
import type { Trace } from "../core.js";
import { csvText } from "../view/csv.js";
import { called, roles } from "../view/observers.js";
import { stepRow } from "./row.js";

export function csv(trace: Trace): string {
  const head = [
    "step",
    "action",
    ...roles.flatMap((role) => [`${called[role]} symbol`, `${called[role]} states`, `${called[role]} goals`]),
    "goal difference",
  ];
  const rows = trace.steps.map((shown, index) => {
    const { step, action, observers, difference } = stepRow(shown, index);
    const seen = roles.flatMap((role) => {
      const { symbol, states, goals } = observers[role];
      return [symbol, states, goals.join("; ")];
    });
    return [step, action, ...seen, difference];
  });
  return csvText([head, ...rows]);
}
