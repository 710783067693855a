// All that an observer was told so far, or all that the agent did, one mark a step. Choosing one shows its step.

import { html, type TemplateResult } from "lit";
import type { TraceStep } from "../core.js";
import { visible } from "../problem/unseen.js";
import type { Boards } from "../state/boards.js";
import type { Timeline } from "../state/timeline.js";
import { actionText } from "../view/action.js";
import { named } from "../view/names.js";
import type { BoardName } from "./board-input.js";

export interface SymbolStores {
  timeline: Timeline;
  boards: Boards;
}

const labels: Record<BoardName, string> = {
  actor: "Actions so far",
  adversarial: "What the enemy was told so far",
  cooperative: "What the friend was told so far",
};

/** `alone`: there is one observer, who is neither enemy nor friend. */
export function symbols(name: BoardName, playground: SymbolStores, alone: boolean): TemplateResult {
  const { trace, step } = playground.timeline;
  const of = (shown: TraceStep) => (name === "actor" ? actionText(shown.action) : visible(shown.symbols[name] ?? ""));
  const steps = trace.value?.steps.slice(1) ?? [];
  // As the enemy one sees what has come, not what will.
  const seen = playground.boards.mode.value === "guess" ? steps.slice(0, step.value) : steps;
  return html`<ol class="symbols" aria-label=${alone && name !== "actor" ? "What the observer was told so far" : labels[name]}>
    ${seen.map((shown, index) => {
      const at = index + 1;
      const when = at === step.value ? "now" : at < step.value ? "past" : "future";
      return html`<li class=${when} aria-current=${at === step.value ? "step" : "false"} aria-hidden=${String(at > step.value)}
        title="Step ${at}: ${named(of(shown))}" @click=${() => playground.timeline.goTo(at)}>${of(shown)}</li>`;
    })}
  </ol>`;
}

/** Keeps the present symbol in sight, in each of the rows. */
export function followSymbols(root: ParentNode): void {
  for (const row of root.querySelectorAll<HTMLElement>(".symbols")) {
    const now = row.querySelector<HTMLElement>(".now");
    const middle = now === null ? 0 : now.offsetLeft + now.offsetWidth / 2 - row.clientWidth / 2;
    row.scrollLeft = Math.max(0, middle);
  }
}
