// The steps as a table for a spreadsheet.
import type { Trace } from "../core.js";
import { csvText } from "../view/csv.js";
import { called, roles } from "../view/observers.js";
import { stepRows } from "./row.js";

export function csv(trace: Trace): string {
  const head = [
    "step",
    "action",
    ...roles.flatMap((role) => [`${called[role]} symbol`, `${called[role]} states`, `${called[role]} goals`]),
    "goal difference",
  ];
  const rows = stepRows(trace).map(({ step, action, observers, difference }) => {
    const seen = roles.flatMap((role) => {
      const { symbol, states, goals } = observers[role];
      return [symbol, states, goals.join("; ")];
    });
    return [step, action, ...seen, difference ?? ""];
  });
  return csvText([head, ...rows]);
}
