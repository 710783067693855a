// The goals that an observer still thinks possible at the step shown.

import { html, nothing, type TemplateResult } from "lit";
import { glossaryLink } from "../help/glossary-link.js";
import { visible } from "../problem/unseen.js";
import type { Boards } from "../state/boards.js";
import { star } from "../view/icons.js";
import { inTurns } from "../view/in-turns.js";
import { longList } from "../view/long-list.js";
import { named } from "../view/names.js";
import { wholeNumber } from "../view/numbers.js";
import { called, type Role } from "../view/observers.js";
import { stateCount } from "./belief-size.js";
import type { BoardInput } from "./board-input.js";
import { type GoalView, goalViews } from "./goal-attributes.js";
import { looks } from "./goal-marks.js";
import { isGrid } from "./grid/cells.js";
import { signs } from "./standing-signs.js";
import { reason, type WhyStores } from "./why.js";

export interface SurvivorStores extends WhyStores {
  boards: Boards;
}

/** More goals than these are a list to scroll. */
const MANY = 12;

/** What choosing a goal shows. Who plays the enemy is shown nothing that is still to come. */
function offer({ name, standing }: GoalView, role: Role, { boards: { story, mode } }: SurvivorStores): string {
  if (mode.value === "guess") return standing[role];
  if (standing[role] !== "possible") return "show why it is not possible";
  return story.endOf(name, role) === null ? "possible, and at the end as well" : "possible; show until when";
}

export function survivors(role: Role, { scene, shown }: BoardInput, playground: SurvivorStores): TemplateResult {
  const { story, mode } = playground.boards;
  const goals = goalViews(scene, shown);
  const list = longList(playground.boards, goals, "goals", ({ isTrue }) => isTrue);
  const count = goals.filter((goal) => goal.standing[role] === "possible").length;
  const states = stateCount(shown, role);
  const noun = isGrid(scene) ? "place" : "state";
  return html`<p class="belief">
      ${glossaryLink("belief", "Believes")} in <b>${wholeNumber(states)}</b> ${noun}${states === 1 ? "" : "s"}: <b>${count}</b> of ${goals.length} goals ${glossaryLink("possible", "possible")}
    </p>
    <ul class="survivors ${goals.length > MANY ? "many" : ""}" tabindex=${goals.length > MANY ? 0 : nothing} aria-label="Goals for the ${called[role]}">
      ${inTurns(
        list.shown,
        ({ item: goal }) => html`<li class=${looks[goal.standing[role]]} data-goal=${goal.name}
          data-adversarial=${goal.attributes.adversarial} data-cooperative=${goal.attributes.cooperative}
          ?data-true-goal=${goal.isTrue} title="${named(goal.name)}: ${offer(goal, role, playground)}"
          @click=${() => mode.value !== "guess" && story.ask(goal.name, role)}>
          ${signs[goal.standing[role]]}<span class="name">${visible(goal.name)}</span>${goal.isTrue ? star : ""}
          <span class="unseen">${goal.standing[role]}</span>
        </li>`,
      )}
    </ul>
    ${list.more}
    ${reason(role, noun, goals.find(({ name }) => name === story.goal.value)?.standing[role], playground)}`;
}
