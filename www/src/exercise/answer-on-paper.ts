// Room to write an answer on paper, where there is nothing to tick.
import { html, nothing, type TemplateResult } from "lit";
import type { Question } from "../core.js";
import type { Exercise } from "../state/exercise.js";
import { actionText } from "../view/action.js";
import { isCell } from "./cell-grid.js";

/** More states are several sheets to tick. */
const MOST_STATES = 60;
/** More actions stand in the problem in words alone. */
const MOST_ACTIONS = 12;

/** Stands in the place of the controls that follow it. */
export function answerOnPaper(exercise: Exercise, question: Question): TemplateResult | typeof nothing {
  const { choice, choices } = question.form;
  if (choice === "action") return walk(exercise, choices.map(String));
  const isLong = choice === "state" && choices.length > MOST_STATES && !choices.every(isCell);
  return isLong ? toWrite("States that are possible") : nothing;
}

function walk({ choices }: Exercise, names: readonly string[]): TemplateResult {
  const given = choices.value.map((choice) => actionText(names[choice] ?? "")).join(", ");
  const known = names.length > MOST_ACTIONS ? nothing : html`<p>Actions: ${names.map(actionText).join(", ")}.</p>`;
  return given === ""
    ? toWrite("The walk", known)
    : html`<div class="choices on-paper">${known}<p class="walk">${given}</p></div>`;
}

const toWrite = (label: string, before: TemplateResult | typeof nothing = nothing): TemplateResult =>
  html`<div class="choices on-paper"><p>${label}:</p>${before}<div class="lines"></div></div>`;
