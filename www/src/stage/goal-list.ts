// The candidate goals, and whether each is possible for each observer: at the step shown, and at the end.

import { html, type TemplateResult } from "lit";
import { glossaryLink } from "../help/glossary-link.js";
import { visible } from "../problem/unseen.js";
import type { Boards } from "../state/boards.js";
import type { Timeline } from "../state/timeline.js";
import { star } from "../view/icons.js";
import { inTurns } from "../view/in-turns.js";
import { longList } from "../view/long-list.js";
import { named } from "../view/names.js";
import { called, type Role, roles } from "../view/observers.js";
import { type GoalView, goalViews } from "./goal-attributes.js";
import { looks } from "./goal-marks.js";
import { isGrid } from "./grid/cells.js";
import { viewOf } from "./lazy-views.js";
import { signs } from "./standing-signs.js";

interface GoalListStores {
  timeline: Timeline;
  boards: Boards;
}

export function goalList(playground: GoalListStores): TemplateResult | "" {
  const scene = playground.boards.scene.value;
  const { shown, trace } = playground.timeline;
  const end = trace.value?.steps.at(-1);
  if (scene === null || shown.value === null || end === undefined) return "";
  const ends = goalViews(scene, end);
  const view = isGrid(scene) ? null : viewOf(scene);
  const asked = (index: number) => {
    const words = view?.goal?.(index) ?? "";
    return words === "" ? "" : html`<span class="asked">${words}</span>`;
  };
  const guessing = playground.boards.mode.value === "guess";
  const list = longList(playground.boards, goalViews(scene, shown.value), "goals", ({ isTrue }) => isTrue);
  const known = !guessing && playground.boards.difference.value !== null;
  const shownRoles = guessing ? roles.filter((role) => role === "adversarial") : roles;
  return html`<table class="goals">
    <caption>Which ${glossaryLink("candidate-goal", "goals")} are ${glossaryLink("possible", "possible")}?</caption>
    <thead>
      <tr>
        <th scope="col">Goal</th>
        ${shownRoles.map((role) => html`<th scope="col" class=${role}>For the ${called[role]}</th>`)}
      </tr>
    </thead>
    <tbody>
      ${inTurns(
        list.shown,
        ({ item: goal, index }) => html`<tr data-goal=${goal.name} data-adversarial=${goal.attributes.adversarial}
          data-cooperative=${goal.attributes.cooperative} ?data-true-goal=${goal.isTrue}>
          <th scope="row">
            ${
              guessing
                ? html`<span class="name" title=${named(goal.name)}>${visible(goal.name)}</span>`
                : html`<button type="button" class="choose name" title="${named(goal.name)}: show until when it is possible"
                    @click=${() => playground.boards.story.choose(goal.name)}>${visible(goal.name)}</button>`
            }
            ${goal.isTrue ? html`<span class="true">${star}true goal</span>` : ""}
            ${asked(index)}
          </th>
          ${shownRoles.map((role) => survival(role, goal, known ? ends[index] : undefined))}
        </tr>`,
      )}
    </tbody>
  </table>
  ${list.more}
  <p class="story" role="status">${guessing ? "" : playground.boards.story.sentence.value || "Choose a goal to see until when it is possible, and which symbol ends that."}</p>`;
}

function survival(role: Role, goal: GoalView, end: GoalView | undefined): TemplateResult {
  const standing = goal.standing[role];
  return html`<td class="${role} ${looks[standing]}">
    ${signs[standing]}${standing}
    ${end === undefined ? "" : html`<span class="end">at the end: ${end.standing[role]}</span>`}
  </td>`;
}
