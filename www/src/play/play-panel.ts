// Playing: being the agent, or being the enemy.
import { html, nothing, type TemplateResult } from "lit";
import type { OpenProblem } from "../state/open-problem.js";
import { playgroundAround } from "../view/surroundings.js";
import { type GuessPanelStores, guessPanel } from "./guess-panel.js";
import { boardsInView } from "./in-view.js";
import { type WalkPanelStores, walkPanel } from "./walk-panel.js";

export type PlayPanelStores = GuessPanelStores & WalkPanelStores & { problem: OpenProblem };

/** The button that was pressed goes away: the focus moves to where the walk is made. */
async function takeOver(playground: PlayPanelStores, { currentTarget }: Event): Promise<void> {
  const element = playgroundAround(currentTarget as Element);
  await playground.walk.start();
  requestAnimationFrame(() => {
    element?.querySelector<HTMLElement>(".walkable, .walk-controls :is(input, button)")?.focus({ preventScroll: true });
    boardsInView(element, ".panel.actor");
  });
}

async function startGuessing(playground: PlayPanelStores, { currentTarget }: Event): Promise<void> {
  const element = playgroundAround(currentTarget as Element);
  await playground.guess.start();
  requestAnimationFrame(() => boardsInView(element, ".panel.adversarial"));
}

export function playPanel(playground: PlayPanelStores): TemplateResult {
  const closed = playground.problem.closed.value;
  const veiled = playground.problem.veiled.value;
  const round = playground.guess.round.value.kind;
  if (playground.boards.mode.value === "walk") return walkPanel(playground);
  if (round !== "none") return guessPanel(playground);
  return html`<div class="play choices">
    <div>
      <h3>You are the agent</h3>
      <p>Walk yourself.${veiled ? "" : ` See what the enemy and the friend make of every step${closed ? "" : ", and how close you come to the best plan"}.`}</p>
      <button type="button" class="primary" @click=${(event: Event) => void takeOver(playground, event)}>Take over</button>
    </div>
    ${closed ? nothing : enemy(playground)}
  </div>`;
}

/** What is to be guessed is a solver's plan. */
const enemy = (playground: PlayPanelStores): TemplateResult => html`<div>
  <h3>You are the enemy</h3>
  <p>A goal is drawn, and you know only what the enemy is told. Guess where the agent is going.</p>
  <button type="button" class="primary" @click=${(event: Event) => void startGuessing(playground, event)}>Start guessing</button>
</div>`;
