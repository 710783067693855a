// Why the goal that was chosen is not possible for an observer: in words under its goals, and on its board the last states
// that would have led there.
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Elimination, Nearest, State } from "../core.js";
import { glossaryLink } from "../help/glossary-link.js";
import type { Timeline } from "../state/timeline.js";
import type { Why } from "../state/why.js";
import { actionText } from "../view/action.js";
import { brief } from "../view/names.js";
import { counted } from "../view/numbers.js";
import { called, type Role } from "../view/observers.js";
import type { Standing } from "./goal-attributes.js";

export interface WhyStores {
  why: Why;
  timeline: Timeline;
}

/** More symbols or actions would hide what they are examples of. */
const MOST_NAMED = 3;

export function reason(
  role: Role,
  noun: string,
  standing: Standing | undefined,
  { why, timeline }: WhyStores,
): TemplateResult | typeof nothing {
  const known = why.of(role);
  if (known === undefined || standing === undefined || standing === "possible") return nothing;
  const { goal, cause } = known;
  return html`<p class="because" role="status"><b>${brief(goal)}</b> ${
    standing === "ruled out" ? glossaryLink("possible", "ruled out") : "not possible now"
  }: ${isNearest(cause) ? far(goal, role, noun, cause, timeline) : words(role, noun, cause)}</p>`;
}

const isNearest = (cause: Elimination | Nearest | null): cause is Nearest | null =>
  cause === null || "actions" in cause;

/** No believed state was ever one action away: how far it is now, or since when no way leads there. */
function far(goal: string, role: Role, noun: string, nearest: Nearest | null, timeline: Timeline): TemplateResult {
  const steps = timeline.trace.value?.steps ?? [];
  const ruledOut = (step: number) => steps[step]?.ruled_out?.[role].includes(goal) === true;
  const now = timeline.step.value;
  if (nearest?.actions === null) {
    let since = now;
    while (since > 0 && ruledOut(since - 1)) since -= 1;
    if (since === 0) return html`no way leads to it from any ${noun} believed at the start.`;
    return html`since step ${since}, <b>${brief(steps[since]?.symbols[role] ?? "")}</b>, no way leads to it from any ${noun} believed.`;
  }
  const away =
    nearest === null
      ? `no ${noun} believed until now was one action away from it`
      : `from the nearest ${noun} believed now it is ${counted(nearest.actions, "action")} away`;
  return html`${away}${ruledOut(now) ? ", and the plan ends here" : ""}.`;
}

function words(role: Role, noun: string, { step, symbol, led, led_count, held_count }: Elimination): TemplateResult {
  if (led_count === 0) {
    return html`the agent could be there before step ${step}, in ${counted(held_count, noun)}; <b>${brief(symbol)}</b> led on from it.`;
  }
  const symbols = examples(led.map((missed) => missed.symbol));
  const actions = examples(led.map(({ action }) => actionText(action)));
  return html`before step ${step} it was one action away (${actions}) from ${counted(led_count, noun)}: <b>${symbols}</b>. The ${called[role]}
    was told <b>${brief(symbol)}</b>.`;
}

/** The first few different ones. */
function examples(all: readonly string[]): string {
  const different = [...new Set(all)];
  return `${different.slice(0, MOST_NAMED).map(brief).join(", ")}${different.length > MOST_NAMED ? ", …" : ""}`;
}

/** Where the agent stands in a state of a format with cells. */
function cellIn(state: State): [number, number] | null {
  const cell = typeof state === "object" && "robot" in state ? state.robot : state;
  return Array.isArray(cell) && typeof cell[0] === "number" ? [cell[0], Number(cell[1])] : null;
}

/** A ring around each cell from which one action would have led to the goal, with an arrow that way, crossed out. */
export function reasonMarks(role: Role, { why }: Pick<WhyStores, "why">) {
  const cause = why.of(role)?.cause ?? null;
  if (isNearest(cause)) {
    // Where it holds in a believed state it is possible.
    const cell = cause === null || cause.state === null || cause.actions === 0 ? null : cellIn(cause.state);
    return cell === null ? nothing : svg`<g class="reason" data-reason="now">${ring(cell)}</g>`;
  }
  const elimination = cause;
  const led = elimination.led.flatMap(({ state, result }) => {
    const [from, to] = [cellIn(state), cellIn(result)];
    return from === null || to === null ? [] : [{ from, to }];
  });
  const held = elimination.led_count > 0 ? [] : elimination.held.map(cellIn);
  const rings = [...led.map(({ from }) => from), ...held.filter((cell) => cell !== null)];
  return svg`<g class="reason" data-reason=${elimination.step}>
    ${rings.map(ring)}
    ${led.filter(({ from, to }) => from[0] !== to[0] || from[1] !== to[1]).map(arrow)}
  </g>`;
}

const ring = ([column, row]: [number, number]) =>
  svg`<rect class="last" x=${column + 0.1} y=${row + 0.1} width="0.8" height="0.8" rx="0.16"></rect>`;

/** From the edge of one cell into the other, with a bar across: it did not happen. */
function arrow({ from, to }: { from: [number, number]; to: [number, number] }) {
  const angle = (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;
  return svg`<path class="missed" transform="translate(${from[0] + 0.5} ${from[1] + 0.5}) rotate(${angle})"
    d="M0.3 0H0.66M0.56 -0.1L0.66 0L0.56 0.1M0.44 -0.14V0.14"></path>`;
}
