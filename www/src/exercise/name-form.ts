// Whose question it is, where it differs from student to student and the page has not said.
import { html, type TemplateResult } from "lit";
import type { Exercise } from "../state/exercise.js";

export function nameForm(exercise: Exercise): TemplateResult {
  const give = (event: SubmitEvent) => {
    event.preventDefault();
    const name = new FormData(event.target as HTMLFormElement).get("name");
    if (typeof name === "string" && name.trim() !== "") void exercise.call(name);
  };
  return html`<form class="whose" @submit=${give}>
    <p id="exercise-whose">Each student has a question of their own. The same name always gives the same one: write yours as your course does.</p>
    <div class="actions">
      <label>Your name or number <input type="text" name="name" maxlength="200" required autocomplete="off" spellcheck="false"
        aria-describedby="exercise-whose" .value=${exercise.name.value ?? ""} /></label>
      <button type="submit" class="primary">Show my question</button>
      <button type="button" @click=${() => void exercise.call("")}>Without a name</button>
    </div>
    <p role="status">${said(exercise)}</p>
  </form>`;
}

function said({ name, error }: Exercise): string {
  if (name.value === null) return error.value ?? "";
  return name.value === "" ? "This is the question without a name." : `This is the question of ${name.value}.`;
}
