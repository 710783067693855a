// A walk as an answer: what can be done now, the steps so far, and where they have led.
import { html, type TemplateResult } from "lit";
import type { Question } from "../core.js";
import type { Exercise } from "../state/exercise.js";
import { actionText } from "../view/action.js";
import { counted } from "../view/numbers.js";
import { stateText } from "./state-text.js";

/** More actions than these are found by their names in a list. */
const MOST_BUTTONS = 12;

export function walkForm(exercise: Exercise, question: Question): TemplateResult {
  const names = question.form.choices.map(String);
  const next = new Set(exercise.next.value?.map(({ action }) => action) ?? []);
  const choices = exercise.choices.value;
  const buttons = names.length <= MOST_BUTTONS ? names : names.filter((name) => next.has(name));
  return html`<fieldset class="choices">
    <legend>The next step</legend>
    <div class="next-steps">${buttons.map((name) => {
      const possible = next.has(name);
      return html`<button type="button" data-action=${name} aria-disabled=${String(!possible)}
        @click=${() => possible && exercise.choose(names.indexOf(name))}>${actionText(name)}</button>`;
    })}</div>
    <p class="walk" data-walk>${
      choices.length === 0 ? "No steps yet." : choices.map((choice) => actionText(names[choice] ?? "")).join(", ")
    }</p>
    <div class="actions">
      <button type="button" aria-disabled=${String(choices.length === 0)} @click=${() => choices.length > 0 && exercise.back()}>
        Take back a step</button>
      <button type="button" aria-disabled=${String(choices.length === 0)} @click=${() => choices.length > 0 && exercise.clear()}>
        Start over</button>
    </div>
    <p role="status" class="where">${where(exercise, question)}</p>
  </fieldset>`;
}

function where({ last, choices }: Exercise, question: Question): string {
  const step = last.value;
  if (step === null) return "";
  const place = `After ${counted(choices.value.length, "step")}: ${stateText(step.state)}.`;
  if (question.hide.includes("beliefs")) return place;
  const goals = (names: readonly string[]) => (names.length === 0 ? "none" : names.join(", "));
  return `${place} Goals possible for the enemy: ${goals(step.goals.adversarial)}; for the friend: ${goals(step.goals.cooperative)}.`;
}
