// The controls of an answer: a list of choices, a grid of cells, or the steps of a walk.
import { html, type TemplateResult } from "lit";
import type { Question } from "../core.js";
import type { Exercise } from "../state/exercise.js";
import { actionText } from "../view/action.js";
import { named } from "../view/names.js";
import { cellGrid, isCell } from "./cell-grid.js";
import { stateList } from "./state-list.js";
import { walkForm } from "./walk-form.js";

export function answerForm(exercise: Exercise, question: Question): TemplateResult {
  const { choices, arity, choice } = question.form;
  if (choice === "action") return walkForm(exercise, question);
  if (choices.every(isCell)) return cellGrid(exercise, question);
  if (choice === "state") return stateList(exercise, question);
  const type = arity === "one" ? "radio" : "checkbox";
  const legend = arity === "one" ? "The goal" : "Goals that are possible";
  return html`<fieldset class="choices">
    <legend>${legend}</legend>
    ${choices.map((label, index) => {
      const text = named(actionText(String(label)));
      return html`<label><input type=${type} name="choice" .checked=${exercise.choices.value.includes(index)}
        @change=${() => exercise.choose(index)} /> ${text}</label>`;
    })}
  </fieldset>`;
}
