// Choosing a solver and what is asked of it, and starting or ending the work.
import { html, nothing, type TemplateResult } from "lit";
import { type Form, reads, solverNames, solvers } from "../state/form.js";
import type { Playground } from "../state/playground.js";
import { result } from "./result.js";

export function solverForm(playground: Playground): TemplateResult {
  const form = playground.form.value;
  const solving = playground.status.value === "solving";
  const submit = (event: Event) => {
    event.preventDefault();
    void playground.solve();
  };
  return html`<form class="solver" @submit=${submit} novalidate>
    <label class="wide">
      <span>Solver</span>
      <select @change=${(event: Event) => playground.edit({ solver: valueIn(event) as Form["solver"] })}>
        ${solverNames.map((name) => html`<option value=${name} ?selected=${name === form.solver}>${solvers[name].title}</option>`)}
      </select>
      <small>${solvers[form.solver].about}</small>
    </label>
    ${reads(form, "encoding") ? encoding(playground, form) : nothing}
    ${number(playground, form, "k", "Enemy keeps at least", "goals (k)", "no bound")}
    ${number(playground, form, "j", "Friend keeps at most", "goals (j)", "no bound")}
    ${number(playground, form, "horizon", "Plan length", "moves", form.solver === "ip" ? "shortest" : "any")}
    <div class="actions">
      <button type="submit" class="primary" ?disabled=${playground.scene.value === null}>Solve</button>
      <button type="button" ?disabled=${!solving} @click=${() => playground.cancel()}>Cancel</button>
    </div>
    ${result(playground)}
  </form>`;
}

function encoding(playground: Playground, form: Form): TemplateResult {
  const choices: [Form["encoding"], string][] = [
    ["belief-flow", "Belief flow (fast)"],
    ["paper", "As in the paper (slow)"],
  ];
  return html`<label class="wide">
    <span>Encoding</span>
    <select @change=${(event: Event) => playground.edit({ encoding: valueIn(event) as Form["encoding"] })}>
      ${choices.map(([value, title]) => html`<option value=${value} ?selected=${value === form.encoding}>${title}</option>`)}
    </select>
  </label>`;
}

function number(
  playground: Playground,
  form: Form,
  field: "k" | "j" | "horizon",
  label: string,
  unit: string,
  empty: string,
): TemplateResult | typeof nothing {
  if (!reads(form, field)) return nothing;
  return html`<label>
    <span>${label}</span>
    <input type="text" inputmode="numeric" autocomplete="off" name=${field} placeholder=${empty} .value=${form[field]}
      @input=${(event: Event) => playground.edit({ [field]: valueIn(event) })} />
    <small>${unit}</small>
  </label>`;
}

const valueIn = (event: Event): string => (event.target as HTMLInputElement | HTMLSelectElement).value;
