// The head of a panel: who it is about, and what has just happened to them.

import { html, type TemplateResult } from "lit";
import { visible } from "../problem/unseen.js";
import type { Boards } from "../state/boards.js";
import type { Timeline } from "../state/timeline.js";
import { actionText } from "../view/action.js";
import { agentFace, enemyEye, friendEye } from "../view/icons.js";
import { named } from "../view/names.js";
import type { BoardName } from "./board-input.js";

export interface PanelHeadStores {
  timeline: Timeline;
  boards: Boards;
}

const heads: Record<BoardName, [icon: TemplateResult, title: string]> = {
  actor: [agentFace, "What the agent does"],
  adversarial: [enemyEye, "What the enemy believes"],
  cooperative: [friendEye, "What the friend believes"],
};

/** `alone`: there is one observer, who is neither enemy nor friend. */
export function panelHead(name: BoardName, playground: PanelHeadStores, alone: boolean): TemplateResult {
  const [icon, title] = heads[name];
  return html`<h2>${icon}${alone && name !== "actor" ? "What the observer believes" : title}</h2>
    <p class="latest">${now(name, playground)}</p>`;
}

function now(name: BoardName, { timeline, boards: { mode } }: PanelHeadStores): TemplateResult | string {
  const shown = timeline.shown.value;
  if (shown === null || (mode.value === "guess" && name !== "adversarial")) return "";
  if (name === "actor") {
    const who = mode.value === "walk" ? "You" : "The agent";
    if (shown.action === null) return `${who} ${mode.value === "walk" ? "stand" : "stands"} at the start.`;
    return html`${who} did <b title=${shown.action}>${actionText(shown.action)}</b>.`;
  }
  const symbol = shown.symbols[name];
  return symbol === null ? "Was told nothing yet." : html`Was told <b title=${named(symbol)}>${visible(symbol)}</b>.`;
}
