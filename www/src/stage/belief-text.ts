// A board for problems that are not drawn: the state, or the believed states, as text.
import { html, type TemplateResult } from "lit";
import type { State, TraceStep } from "../core.js";
import type { BoardName } from "./board-input.js";

/** A belief can hold thousands of states; nobody reads more than these. */
const MOST = 100;

export function beliefText(name: BoardName, shown: TraceStep): TemplateResult {
  const states = name === "actor" ? [shown.state] : shown.beliefs[name];
  const rest = states.length - MOST;
  return html`<ul class="states" data-board=${name} tabindex="0" aria-label=${name === "actor" ? "The state" : "Believed states"}>
    ${states.slice(0, MOST).map((state) => html`<li ?data-believed=${name !== "actor"}>${inWords(state)}</li>`)}
    ${rest > 0 ? html`<li>and ${rest} more</li>` : ""}
  </ul>`;
}

function inWords(state: State): string {
  if (typeof state === "string") return state;
  if (Array.isArray(state)) return state.join(", ");
  return Object.entries(state)
    .map(([part, value]) => `${part} ${Array.isArray(value) ? value.join(",") : value}`)
    .join("; ");
}
