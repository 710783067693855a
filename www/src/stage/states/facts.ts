// Domains without a picture of their own: the facts of a state, grouped by what they say, as text.
import { html, type TemplateResult } from "lit";
import type { State } from "../../core.js";
import { atomOf, atomsOf, factsOf, type PddlScene } from "../pddl/atoms.js";
import type { StateKind } from "./kind.js";

/** "holding: a; on: b c, d e" */
export function factsKind(scene: PddlScene): StateKind {
  return {
    atOnce: 1,
    picture: (state) => grouped(state),
    described: (state) => factsOf(state).map(cellText).join(", ") || "no fact holds",
    words: cellText,
    goal: (index) => scene.goals[index]?.condition ?? "",
  };
}

/** States that are names: the name says it all. */
export function namesKind(): StateKind {
  const named = (state: State) => (typeof state === "string" ? state : JSON.stringify(state));
  return {
    atOnce: 20,
    picture: (state) => html`<span class="state-name">${named(state)}</span>`,
    described: named,
    words: (fact) => fact,
    goal: () => "",
  };
}

function cellText(fact: string): string {
  const { predicate, objects } = atomOf(fact);
  return [predicate, ...objects].join(" ");
}

function grouped(state: State): TemplateResult {
  const groups = new Map<string, string[]>();
  for (const { predicate, objects } of atomsOf(state)) {
    groups.set(predicate, [...(groups.get(predicate) ?? []), objects.join(" ")]);
  }
  if (groups.size === 0) return html`<p class="facts">No fact holds.</p>`;
  return html`<dl class="facts">
    ${[...groups].map(
      ([predicate, all]) => html`<div><dt>${predicate}</dt>
        ${all.map((objects) => html`<dd>${objects === "" ? "yes" : objects}</dd>`)}</div>`,
    )}
  </dl>`;
}
