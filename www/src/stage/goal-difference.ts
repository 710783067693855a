// The goal difference at the step shown, and what it is made of.
import { html, nothing, type TemplateResult } from "lit";
import { glossaryLink } from "../help/glossary-link.js";
import type { Timeline } from "../state/timeline.js";
import { shortNumber } from "../view/numbers.js";
import { type BestPossibleStores, bestPossible, isImpossible } from "./best-possible.js";

export interface GoalDifferenceStores extends BestPossibleStores {
  timeline: Timeline;
}

export function goalDifference(playground: GoalDifferenceStores): TemplateResult | "" {
  const scene = playground.boards.scene.value;
  const { shown, step, lastStep } = playground.timeline;
  if (scene === null || shown.value === null) return "";
  const { adversarial, cooperative } = shown.value.goals;
  const walking = playground.boards.mode.value === "walk";
  // Without a plan the goals at the start make no difference of a plan.
  const value = isImpossible(playground) && !walking ? "none" : shortNumber(shown.value.goal_difference);
  const final = playground.boards.difference.value;
  const atEnd = step.value === lastStep.value;
  const waiting = playground.answer.status.value === "solving" ? "Looking for a plan." : "No plan yet.";
  // That there can be no plan is said beside it.
  const lacking = walking ? "You are not at the true goal." : isImpossible(playground) ? "" : waiting;
  const now = final === null ? lacking : atEnd ? "The plan ends here." : `At the end: ${shortNumber(final)}.`;
  return html`<div class="difference">
    <p class="value"><span>${glossaryLink("goal-difference", "Goal difference")}</span> <b>${value}</b></p>
    ${
      value === "none"
        ? nothing
        : html`<p class="parts" title="goals possible for the enemy minus goals possible for the friend, over the number of goals minus one">
      <span class="bracket">(<b class="enemy">${adversarial.length}</b> for the enemy −
        <b class="friend">${cooperative.length}</b> for the friend)</span>
      <span class="bracket">÷ (${scene.goals.length} − 1)</span>
    </p>`
    }
    <div class="after">${now === "" ? nothing : html`<p class="final">${now}</p>`} ${
      // Of the problem that is open, not of the goal that was drawn.
      playground.boards.disguise.value === null ? bestPossible(playground) : nothing
    }</div>
  </div>`;
}
