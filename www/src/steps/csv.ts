// The steps as comma-separated values (RFC 4180), for a spreadsheet.
import type { Trace } from "../core.js";
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
      return [text(symbol), String(states), text(goals.join("; "))];
    });
    return [String(step), text(action), ...seen, String(difference)];
  });
  return [head, ...rows].map((row) => `${row.join(",")}\r\n`).join("");
}

/** Names are the document's: a spreadsheet must not take one for a formula. */
function text(value: string): string {
  const harmless = /^[=+\-@\t\r]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(harmless) ? `"${harmless.replaceAll('"', '""')}"` : harmless;
}
