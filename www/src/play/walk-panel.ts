// The controls of a walk: what can be done now, a step back, and how the walk compares with the best of its length.
import { html, type TemplateResult } from "lit";
import type { Scene } from "../core.js";
import type { Boards } from "../state/boards.js";
import type { OpenProblem } from "../state/open-problem.js";
import type { Timeline } from "../state/timeline.js";
import type { Verdict, Walk } from "../state/walk.js";
import { counted, differenceText } from "../view/numbers.js";

export interface WalkPanelStores {
  walk: Walk;
  boards: Boards;
  timeline: Timeline;
  problem: OpenProblem;
}

/** How each kind of board is walked on, by key and by touch. */
const hints: Partial<Record<Scene["format"], { keys: string; touch: string }>> = {
  gridworld: {
    keys: "Use the arrow keys on the agent's board, click a cell beside the agent, or the arrows under the board.",
    touch: "Touch a cell beside the agent, or the arrows under its board.",
  },
  "box-pushing": {
    keys: "Use the keys on the agent's board (up: move forward, left and right: turn, S: stay), or the buttons under it.",
    touch: "Use the buttons under the agent's board.",
  },
  "recycling-robot": {
    keys: "Use the keys on the agent's board (arrows, P: pick up, D: drop, C: charge, S: stay), or the buttons under it.",
    touch: "Use the buttons under the agent's board.",
  },
};

export function walkPanel(playground: WalkPanelStores): TemplateResult {
  const walk = playground.walk;
  const format = playground.boards.scene.value?.format;
  const hint = format === undefined ? undefined : hints[format];
  const { step } = playground.timeline;
  return html`<div class="play walk">
    <p>${
      hint === undefined
        ? "Choose what to do next under the agent's board."
        : html`<span class="by-key">${hint.keys}</span><span class="by-touch">${hint.touch}</span>`
    } Reach the true goal, marked with a star.</p>
    <div class="actions">
      <button type="button" ?disabled=${step.value === 0} @click=${() => void walk.back()}>Take back a step</button>
      <button type="button" ?disabled=${step.value === 0} @click=${() => void walk.start()}>Start over</button>
      <button type="button" @click=${() => walk.leave()}>Stop walking</button>
    </div>
    <div role="status" class="result">
      ${walk.message.value === "" ? "" : html`<p>${walk.message.value}</p>`} ${judged(playground, walk.verdict.value)}
    </div>
  </div>`;
}

function judged({ walk, problem }: WalkPanelStores, verdict: Verdict): TemplateResult | string {
  if (verdict.kind === "walking") return "";
  // The goal difference tells what observers believe.
  if (problem.veiled.value) return html`<p>You are there, in ${counted(verdict.moves, "action")}.</p>`;
  const you = `You: ${differenceText(verdict.difference)} in ${verdict.moves} ${verdict.moves === 1 ? "action" : "actions"}.`;
  if (verdict.kind === "comparing") return html`<p>${you} Looking for the best of that length…</p>`;
  const best = verdict.best.goal_difference;
  if (best === null) return html`<p>${you}</p>`;
  if (verdict.best.status !== "optimal") {
    return html`<p>${you} The best found with as many: ${differenceText(best)}.</p>`;
  }
  if (best <= verdict.difference) return html`<p><b>${you}</b> No plan of that length does better.</p>`;
  return html`<p><b>${you}</b> The best with as many: <b>${differenceText(best)}</b>.
    <button type="button" class="link" @click=${() => void walk.showBest()}>Show it</button></p>`;
}
