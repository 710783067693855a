// The stage: the agent in the middle, the enemy on one side and the friend on the other, all at the same step.
import { html, nothing, type TemplateResult } from "lit";
import { type WalkControlStores, walkControls } from "../play/walk-controls.js";
import { hasWalkKeys, type WalkKeyStores, walkByKey, walkByPointer } from "../play/walk-keys.js";
import type { Answer } from "../state/answer.js";
import { called } from "../view/observers.js";
import type { BoardInput, BoardName } from "./board-input.js";
import { type GoalDifferenceStores, goalDifference } from "./goal-difference.js";
import { type PanelHeadStores, panelHead } from "./panel-head.js";
import { picture } from "./picture.js";
import { type SurvivorStores, survivors } from "./survivors.js";
import { type SymbolStores, symbols } from "./symbols.js";
import type { BoardStores } from "./view.js";

export interface StageStores
  extends BoardStores,
    WalkControlStores,
    WalkKeyStores,
    GoalDifferenceStores,
    PanelHeadStores,
    SurvivorStores,
    SymbolStores {
  answer: Answer;
}

const boardNames: readonly BoardName[] = ["actor", "adversarial", "cooperative"];

/** While the person walks, the agent's board takes arrow keys and touches. */
function walkable(name: BoardName, input: BoardInput, playground: StageStores): TemplateResult {
  const drawn = picture(name, input, playground);
  if (name !== "actor" || playground.boards.mode.value !== "walk" || !hasWalkKeys(input.scene)) return drawn;
  return html`<div class="walkable" tabindex="0" role="application" aria-label="The agent's board: walk with the arrow keys"
    @keydown=${(event: KeyboardEvent) => walkByKey(playground, event)}
    @click=${(event: MouseEvent) => walkByPointer(playground, event)}>${drawn}</div>`;
}

const verdict = (name: BoardName, hidden: boolean, input: BoardInput, playground: StageStores): TemplateResult =>
  html`<div class="verdict">${
    hidden ? nothing : name === "actor" ? goalDifference(playground) : survivors(name, input, playground)
  }</div>`;

/** `left`: what is left out of it, an observer's board (the other is then the only one) and the counts of goals. */
export function stage(playground: StageStores, left: ReadonlySet<string>): TemplateResult {
  const scene = playground.boards.scene.value;
  const { trace, shown, step } = playground.timeline;
  if (scene === null || trace.value === null || shown.value === null) {
    return html`<p class="waiting">${playground.answer.error.value === null ? "Loading…" : "There is nothing to show."}</p>`;
  }
  const input = { scene, trace: trace.value, step: step.value, shown: shown.value };
  const guessing = playground.boards.mode.value === "guess";
  const names = boardNames.filter((name) => name === "actor" || !left.has(called[name]));
  const alone = names.length < boardNames.length;
  return html`<div class="stage" part="boards" data-without=${
    alone
      ? Object.values(called)
          .filter((one) => left.has(one))
          .join(" ")
      : nothing
  }>
    ${names.map((name) => {
      const hidden = guessing && name !== "adversarial";
      return html`<figure class="panel ${name}" part="board ${name}-board" data-hidden=${hidden || nothing}>
        <figcaption>${panelHead(name, playground, alone)} ${hidden ? nothing : symbols(name, playground, alone)}</figcaption>
        ${hidden ? html`<p class="covered">Covered while you are the enemy.</p>` : walkable(name, input, playground)}
        ${name === "actor" && playground.boards.mode.value === "walk" ? walkControls(playground) : nothing}
        ${left.has("counts") ? nothing : verdict(name, hidden, input, playground)}
      </figure>`;
    })}
  </div>`;
}
