// Boards for problems whose states are listed one by one: one state as its picture; some as a picture each, to leaf
// through; many as a summary in numbers, with the pictures below.
import { html, nothing, type TemplateResult } from "lit";
import type { BeliefSummary, Scene, State } from "../../core.js";
import { counted } from "../../view/numbers.js";
import { called, type Role } from "../../view/observers.js";
import { stateCount } from "../belief-size.js";
import type { BoardInput, BoardName } from "../board-input.js";
import type { BoardStores, View } from "../view.js";
import { goalCards } from "./goals.js";
import type { StateKind } from "./kind.js";
import { pageOf, pager } from "./pager.js";
import { summary } from "./summary.js";

/** More states than these are summed up. */
const FEW = 8;

export function statesView(scene: Scene, kind: StateKind): View {
  return {
    goal: (index) => kind.goal(index),
    board: (name, input, playground) => html`<div class="states-board" data-board=${name} tabindex="0" role="group"
      aria-label=${described(name, input, kind)}>
      ${
        name === "actor"
          ? html`<div class="pictures">${one(kind, input.shown.state, false, false)}</div>`
          : believed(scene, kind, name, input, playground)
      }
      ${name === "actor" ? goalCards(input, kind) : nothing}
    </div>`,
  };
}

const one = (kind: StateKind, state: State, isBelieved: boolean, small: boolean): TemplateResult =>
  html`<div class="state" ?data-believed=${isBelieved} role="img" aria-label=${kind.described(state)}>${kind.picture(state, small)}</div>`;

function believed(
  scene: Scene,
  kind: StateKind,
  role: Role,
  { shown }: BoardInput,
  playground: BoardStores,
): TemplateResult {
  const states = shown.beliefs[role];
  const all = stateCount(shown, role);
  const page = pageOf(playground, role, states.length, kind.atOnce);
  const pictures = html`<div class="pictures ${page.count > 1 ? "several" : ""}">
      ${states.slice(page.first, page.first + page.count).map((state) => one(kind, state, true, page.count > 1))}
    </div>
    ${pager(playground, role, page, kind.atOnce, states.length, all)}`;
  const told = shown.summaries?.[role];
  if (told === undefined || all <= FEW || told.shares.length === 0) return pictures;
  return html`${summary(scene, kind, told, kind.merged === undefined ? 6 : 3)} ${kind.merged === undefined ? nothing : merged(kind, kind.merged, told)}
    <details class="single"><summary>Look at single states</summary>${pictures}</details>`;
}

const merged = (_kind: StateKind, picture: (told: BeliefSummary) => TemplateResult, told: BeliefSummary) =>
  html`<div class="state" data-believed role="img" aria-label=${`What may be so in ${counted(told.states, "state")}, in one picture`}>${picture(told)}</div>`;

function described(name: BoardName, { shown, step }: BoardInput, kind: StateKind): string {
  const after = `After ${counted(step, "action")}`;
  if (name === "actor") return `${after}: ${kind.described(shown.state)}.`;
  return `${after} the ${called[name]} holds ${counted(stateCount(shown, name), "state")} possible.`;
}
