// The controls of the guessing game.

import { html, type TemplateResult } from "lit";
import type { Boards } from "../state/boards.js";
import type { Guess, Round } from "../state/guess.js";
import type { Timeline } from "../state/timeline.js";
import type { Workbench } from "../state/workbench.js";
import { inTurns } from "../view/in-turns.js";
import { longList } from "../view/long-list.js";
import { brief, named, visible } from "../view/names.js";

export interface GuessPanelStores {
  guess: Guess;
  boards: Boards;
  timeline: Timeline;
  workbench: Workbench;
}

export function guessPanel(playground: GuessPanelStores): TemplateResult {
  const game = playground.guess;
  const round = game.round.value;
  return html`<div class="play guess">
    ${body(playground, game, round)}
    <div class="actions">
      ${
        round.kind === "over"
          ? html`<button type="button" class="primary" @click=${() => void game.start()}>Another round</button>`
          : ""
      }
      <button type="button" @click=${() => game.leave()}>Leave the game</button>
      ${game.played.value === 0 ? "" : html`<span class="score">${game.right.value} of ${game.played.value} right</span>`}
    </div>
  </div>`;
}

function body(playground: GuessPanelStores, game: Guess, round: Round): TemplateResult | string {
  if (round.kind === "hiding") return html`<p>The agent is choosing its way…</p>`;
  if (round.kind === "impossible")
    return html`<p>No goal of this problem can be reached: there is nothing to guess.</p>`;
  if (round.kind === "over") return html`<div role="status">${told(round)}</div>`;
  const goals = playground.boards.scene.value?.goals ?? [];
  const list = longList(game, goals, "goals");
  const { step, lastStep } = playground.timeline;
  return html`<p>
      Step forward to be told what the enemy is told. Its board shows where the agent could be.
      ${step.value === lastStep.value ? html`<b>The agent has arrived.</b>` : ""}
    </p>
    <p id="${playground.workbench.id}-guess">Which goal is it after?</p>
    <ul class="next ${goals.length > 12 ? "many" : ""}" aria-labelledby="${playground.workbench.id}-guess">
      ${inTurns(list.shown, ({ item: { name } }) => html`<li><button type="button" title=${named(name)} @click=${() => game.guess(name)}>${visible(name)}</button></li>`)}
    </ul>
    ${list.more}`;
}

function told({ guess, goal, step, possible }: Extract<Round, { kind: "over" }>): TemplateResult {
  const verdict =
    guess === goal
      ? html`<b>Right: it was ${brief(goal)}.</b>`
      : html`<b>No: it was ${brief(goal)}, not ${brief(guess)}.</b>`;
  const others =
    possible > 1
      ? `At step ${step} ${possible} goals were possible for the enemy: nobody could have known.`
      : possible === 1
        ? `At step ${step} one goal alone was possible for the enemy.`
        : `At step ${step} the agent could not have arrived anywhere yet: it was a guess.`;
  return html`<p>${verdict} ${others} The boards now show the whole way.</p>`;
}
