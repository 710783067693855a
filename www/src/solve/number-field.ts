// A whole number that may be left open: a field between two buttons, with what it means beside it. A text that is no
// number in the range stays in the field and changes nothing; leaving the field takes the nearest number.

import type { ReadonlySignal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { glossaryLink } from "../help/glossary-link.js";
import type { Term } from "../help/terms.js";
import type { Boards } from "../state/boards.js";
import type { Form } from "../state/form.js";
import { type Drafts, type NumberName, numberIn, range, stepped } from "../state/numbers.js";
import type { Solving } from "../state/solving.js";
import type { Timeline } from "../state/timeline.js";
import type { Workbench } from "../state/workbench.js";

export interface NumberFieldStores {
  form: ReadonlySignal<Form>;
  drafts: Drafts;
  boards: Boards;
  timeline: Timeline;
  solving: Solving;
  workbench: Workbench;
}

interface Words {
  label: string;
  /** What stands in the field while it is open. */
  open: string;
  about: string;
  lower: string;
  raise: string;
  kind: string;
  term: Term;
}

const words: Record<NumberName, Words> = {
  k: {
    label: "Enemy keeps at least",
    open: "no bound",
    about: "k: so many goals must stay possible for the enemy, to keep it in doubt.",
    lower: "Lower k",
    raise: "Raise k",
    kind: "goals",
    term: "k",
  },
  j: {
    label: "Friend keeps at most",
    open: "no bound",
    about: "j: so many goals may stay possible for the friend; with 1 it knows the goal.",
    lower: "Lower j",
    raise: "Raise j",
    kind: "goals",
    term: "j",
  },
  horizon: {
    label: "Plan length",
    open: "any length",
    about: "Plans of exactly so many moves.",
    lower: "One move shorter",
    raise: "One move longer",
    kind: "moves",
    term: "length",
  },
  horizonStep: {
    label: "Raise by",
    open: "not raised",
    about: "While no plan has that length, it is raised by so many moves.",
    lower: "Lower the step",
    raise: "Raise the step",
    kind: "moves",
    term: "length",
  },
};

const integerProgram: Partial<Record<NumberName, Partial<Words>>> = {
  horizon: { open: "the shortest", about: "Plans of exactly so many moves; left open, of the least that will do." },
};

/** `place` tells fields of the same number apart: two tabs can show it. */
export function numberField(playground: NumberFieldStores, name: NumberName, place: string): TemplateResult {
  const id = `${playground.workbench.id}-${place}`;
  const form = playground.form.value;
  const scene = playground.boards.scene.value;
  const said = { ...words[name], ...(form.solver === "ip" ? integerProgram[name] : {}) };
  if (name === "horizonStep" && form.horizon === "") said.open = "by one";
  const drafted = playground.drafts.texts.value[name];
  const moves = playground.timeline.lastStep.value;
  const limits = scene === null ? null : range(name, scene, moves);
  const value = form[name] === "" ? null : Number(form[name]);
  const set = (text: string) => {
    playground.drafts.drop(name);
    if (text !== form[name]) playground.solving.edit({ [name]: text });
  };
  const typed = (event: Event) => {
    const text = (event.target as HTMLInputElement).value;
    const number = limits === null ? undefined : numberIn(text, limits);
    if (text.trim() === "") set("");
    else if (number !== undefined) set(String(number));
    else playground.drafts.keep(name, text);
  };
  const left = () => {
    if (drafted === undefined || limits === null) return;
    const number = /^\s*\d+\s*$/.test(drafted) ? Number(drafted) : null;
    if (number === null) playground.drafts.drop(name);
    else set(String(Math.min(limits.most, Math.max(limits.least, number))));
  };
  const target = (change: 1 | -1) => (limits === null ? undefined : stepped(name, value, change, limits));
  const by = (change: 1 | -1) => () => {
    const next = target(change);
    if (next !== undefined) set(String(next));
  };
  const keys = (event: KeyboardEvent) => {
    const change = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (change === 0) return;
    event.preventDefault();
    by(change)();
  };
  return html`<div class="number">
    <label for=${id}>${glossaryLink(said.term, said.label)}</label>
    <div class="stepped">
      <button type="button" class="sign" aria-label=${said.lower} ?disabled=${target(-1) === undefined}
        @click=${by(-1)}><span aria-hidden="true">−</span></button>
      <input id=${id} type="text" inputmode="numeric" autocomplete="off" name=${name} placeholder=${said.open}
        aria-describedby="${id}-about" aria-invalid=${drafted === undefined ? nothing : "true"}
        .value=${live(drafted ?? form[name])} @input=${typed} @change=${left} @keydown=${keys} />
      <button type="button" class="sign" aria-label=${said.raise} ?disabled=${target(1) === undefined}
        @click=${by(1)}><span aria-hidden="true">+</span></button>
    </div>
    <small id="${id}-about">${
      drafted === undefined || limits === null
        ? said.about
        : html`<span class="invalid">A whole number of ${said.kind} from ${limits.least} to ${limits.most}; empty means “${said.open}”.</span>`
    }</small>
  </div>`;
}
