// The goal difference at the step shown, and what it is made of.
import { html, nothing, type TemplateResult } from "lit";
import { glossaryLink } from "../help/glossary-link.js";
import type { Timeline } from "../state/timeline.js";
import { differenceText } from "../view/numbers.js";
import { type BestPossibleStores, bestPossible, isImpossible } from "./best-possible.js";
import { type InvitationStores, invitation, isInvited } from "./invitation.js";

export interface GoalDifferenceStores extends BestPossibleStores, InvitationStores {
  timeline: Timeline;
}

/**
 * Where the plan ends its goal difference; before that, the two counts: a goal difference is of a plan for the true goal,
 * and of nothing else.
 */
export function goalDifference(playground: GoalDifferenceStores): TemplateResult | "" {
  const scene = playground.boards.scene.value;
  const { shown } = playground.timeline;
  if (scene === null || shown.value === null) return "";
  const { adversarial, cooperative } = shown.value.goals;
  const counts = [adversarial.length, cooperative.length, scene.goals.length] as const;
  const walking = playground.boards.mode.value === "walk";
  const final = playground.boards.difference.value;
  const atEnd = final !== null && playground.boards.ended.value;
  const none = isImpossible(playground) && !walking;
  const waiting = playground.answer.status.value === "solving" ? "Looking for a plan." : "No plan yet.";
  // That there can be no plan is said beside it.
  const lacking = walking
    ? "You are not at the true goal."
    : isImpossible(playground) || playground.problem.closed.value
      ? ""
      : waiting;
  const now =
    final === null ? lacking : atEnd ? "The plan ends here." : `Goal difference at the end: ${differenceText(final)}.`;
  return html`<div class="difference">
    ${none ? value("none") : atEnd ? html`${value(differenceText(final))} ${formula(counts)}` : soFar(playground, counts)}
    <div class="after">${now === "" ? nothing : html`<p class="final">${now}</p>`} ${
      // Of the problem that is open, not of the goal that was drawn.
      playground.boards.disguise.value === null ? bestPossible(playground, final !== null) : nothing
    }</div>
  </div>`;
}

type Counts = readonly [enemys: number, friends: number, goals: number];

const value = (text: string): TemplateResult =>
  html`<p class="value"><span>${glossaryLink("goal-difference", "Goal difference")}</span> <b>${text}</b></p>`;

const formula = ([enemys, friends, goals]: Counts): TemplateResult =>
  html`<p class="parts" title="goals possible for the enemy minus goals possible for the friend, over the number of goals minus one">
    <span class="bracket">(<b class="enemy">${enemys}</b> for the enemy −
      <b class="friend">${friends}</b> for the friend)</span>
    <span class="bracket">÷ (${goals} − 1)</span>
  </p>`;

function soFar(playground: GoalDifferenceStores, [enemys, friends, goals]: Counts): TemplateResult {
  const invited = isInvited(playground);
  return html`${
    invited
      ? invitation(playground)
      : html`<p class="value"><span>Goals ${glossaryLink("possible", "possible")} now</span></p>`
  }
  <p class="parts">
    <span class="bracket"><b class="enemy">${enemys}</b>${invited ? " possible" : ""} for the enemy,</span>
    <span class="bracket"><b class="friend">${friends}</b> for the friend${invited ? "" : `, of ${goals} goals`}</span>
  </p>`;
}
