// Choosing a solver and what is asked of it, and starting or ending the work.
import { html, nothing, type TemplateResult } from "lit";
import { glossaryLink } from "../help/glossary-link.js";
import { type Form, reads, solverNames, solvers } from "../state/form.js";
import { type CommandLineStores, commandLine } from "./command-line.js";
import { type NumberFieldStores, numberField } from "./number-field.js";
import { type ResultStores, result } from "./result.js";

export type SolverFormStores = NumberFieldStores & ResultStores & CommandLineStores;

export function solverForm(playground: SolverFormStores): TemplateResult {
  const form = playground.form.value;
  const exact = form.solver === "exact";
  const id = `${playground.workbench.id}-solver`;
  const submit = (event: Event) => {
    event.preventDefault();
    if (!exact) void playground.solving.solve();
  };
  return html`<form class="solver" @submit=${submit} novalidate>
    <div class="which">
      <label for=${id}>Solver</label>
      <select id=${id} aria-describedby="${id}-about"
        @change=${(event: Event) => playground.solving.edit({ solver: valueIn(event) as Form["solver"] })}>
        ${solverNames.map((name) => html`<option value=${name} .selected=${name === form.solver}>${solvers[name].title}</option>`)}
      </select>
      <small id="${id}-about">${solvers[form.solver].about}${exact ? " Its answers follow at once." : ""}</small>
    </div>
    ${reads(form, "encoding") ? encoding(playground, form) : nothing}
    ${(["k", "j", "horizon", "horizonStep"] as const).map((name) =>
      reads(form, name) ? numberField(playground, name, name) : nothing,
    )}
    ${exact ? nothing : html`<div class="actions">${solveButton(playground)}</div>`}
    ${result(playground)} ${commandLine(playground)}
  </form>`;
}

const solveButton = (playground: SolverFormStores): TemplateResult =>
  html`<button type="submit" class="primary" ?disabled=${playground.boards.scene.value === null}>Solve</button>
    <small>Runs it. After every change you first see the best possible.</small>`;

const encodings: [value: Form["encoding"], title: string, about: string][] = [
  [
    "belief-flow",
    "Belief flow (fast)",
    "Flows over positions and beliefs: few variables, and seldom anything to branch on.",
  ],
  [
    "paper",
    "As in the paper (slow)",
    "A variable for each state, belief and symbol at each step: to learn from and to check.",
  ],
];

function encoding(playground: SolverFormStores, form: Form): TemplateResult {
  const id = `${playground.workbench.id}-encoding`;
  return html`<div class="which">
    <label for=${id}>${glossaryLink("encoding", "Encoding")}</label>
    <select id=${id} aria-describedby="${id}-about"
      @change=${(event: Event) => playground.solving.edit({ encoding: valueIn(event) as Form["encoding"] })}>
      ${encodings.map(([value, title]) => html`<option value=${value} .selected=${value === form.encoding}>${title}</option>`)}
    </select>
    <small id="${id}-about">${encodings.find(([value]) => value === form.encoding)?.[2]}</small>
  </div>`;
}

const valueIn = (event: Event): string => (event.target as HTMLSelectElement).value;
