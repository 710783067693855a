// A state in a line of text.
import type { State } from "../core.js";
import { cellText } from "../problem/cells.js";
import { actionText } from "../view/action.js";

/** Between the parts of a state, as verdicts write it: a cell in words has a comma itself. */
export const between = " · ";

export function stateText(state: State): string {
  if (typeof state === "string") return actionText(state);
  if (!Array.isArray(state))
    return Object.entries(state)
      .map(([part, value]) => `${part} ${placeText(value)}`)
      .join(between);
  const [first] = state;
  return typeof first === "number" ? placeText(state) : state.map((fact) => actionText(String(fact))).join(", ");
}

export const placeText = (value: unknown): string =>
  Array.isArray(value) ? cellText(value as number[]) : String(value);
