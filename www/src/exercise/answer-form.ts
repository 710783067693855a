// The controls of an answer: a list of choices, a grid of cells, or the steps of a walk.
import { html, type TemplateResult } from "lit";
import type { Question } from "../core.js";
import type { Exercise } from "../state/exercise.js";
import { actionText } from "../view/action.js";
import { named } from "../view/names.js";
import { cellGrid, isCell } from "./cell-grid.js";
import { stateText } from "./state-text.js";
import { walkForm } from "./walk-form.js";

export function answerForm(exercise: Exercise, question: Question): TemplateResult {
  const { choices, arity, choice } = question.form;
  if (choice === "action") return walkForm(exercise, question);
  if (choices.every(isCell)) return cellGrid(exercise, question);
  const type = arity === "one" ? "radio" : "checkbox";
  const legend =
    choice === "goal" ? (arity === "one" ? "The goal" : "Goals that are possible") : "States that the agent can be in";
  return html`<fieldset class="choices">
    <legend>${legend}</legend>
    ${choices.map((label, index) => {
      const text = choice === "goal" ? named(actionText(String(label))) : stateText(label);
      return html`<label><input type=${type} name="choice" .checked=${exercise.choices.value.includes(index)}
        @change=${() => exercise.choose(index)} /> ${text}</label>`;
    })}
  </fieldset>`;
}
