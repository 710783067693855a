// The bar above the boards: which problem is open and what it shows, its named plans, and the way to the others.
import { html, nothing, type TemplateResult } from "lit";
import { openHelp } from "../help/help.js";
import type { Boards } from "../state/boards.js";
import type { OpenProblem } from "../state/open-problem.js";
import { down, left, question, right } from "../view/icons.js";
import { entries, type NamedPlan } from "./entries.js";
import { type MenuStores, openGallery } from "./menu.js";
import { thumbnail } from "./thumbnail.js";

export interface ProblemBarStores extends MenuStores {
  problem: OpenProblem;
  boards: Boards;
}

/** `share`: the ways to pass on what is shown, where there are any. */
export function problemBar(playground: ProblemBarStores, share: TemplateResult | typeof nothing): TemplateResult {
  const { gallery } = playground;
  const entry = gallery.current.value;
  const value = playground.problem.document.value?.value;
  const at = entry === null ? -1 : entries.indexOf(entry);
  const where =
    at === -1 ? "All problems" : html`<span class="where-word">Problem</span> ${at + 1} of ${entries.length}`;
  const turn = (label: string, sign: TemplateResult, way: number) =>
    html`<button type="button" class="sign" aria-label=${label} title=${label} @click=${() => void gallery.turn(way)}>${sign}</button>`;
  return html`<section class="problem-bar" part="problem-bar" aria-label="Problem">
    <div class="pick">
      <button type="button" class="current" aria-haspopup="dialog" title="All problems"
        @click=${(event: Event) => openGallery(playground, event.currentTarget as Element)}>
        ${value === undefined ? html`<span class="thumbnail"></span>` : thumbnail(value)}
        <span class="words"><small>${where}</small> <b class="title">${titleOf(playground)}</b></span>${down}
      </button>
      ${turn("Problem before", left, -1)} ${turn("Next problem", right, 1)}
    </div>
    <p class="about">${entry?.about ?? aboutOwn(playground)}</p>
    ${plans(playground, entry?.plans ?? [])}
    <div class="share">
      ${share}
      <button type="button" class="sign" aria-label="Help" title="Help: keys and words (?)" @click=${(event: Event) => void openHelp(undefined, event.currentTarget as Element)}>${question}</button>
    </div>
  </section>`;
}

function titleOf(playground: ProblemBarStores): string {
  const entry = playground.gallery.current.value;
  if (entry !== null) return entry.title;
  if (playground.problem.document.value === null) return "No problem is open yet";
  return playground.problem.canReset.value ? "An edited problem" : "Your own problem";
}

function aboutOwn(playground: ProblemBarStores): string {
  if (playground.problem.document.value === null) return "";
  return playground.problem.canReset.value
    ? "Edited by hand; the link and the saved document hold it as it is now."
    : "Opened from a link, a file or its text.";
}

function plans(playground: ProblemBarStores, named: readonly NamedPlan[]): TemplateResult | typeof nothing {
  // While somebody guesses, a plan would give the answer away.
  if (named.length === 0 || playground.boards.mode.value === "guess") return nothing;
  const { gallery } = playground;
  return html`<div class="plans" role="group" aria-label="Plans to look at">
    ${named.map(
      (plan) => html`<button type="button" aria-pressed=${String(gallery.shows(plan))}
        @click=${() => void gallery.show(plan)}>${plan.title}</button>`,
    )}
  </div>`;
}
