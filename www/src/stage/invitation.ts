// The invitation to watch a plan from its first step, while none of it was seen.
import { html, nothing, type TemplateResult } from "lit";
import type { Tour } from "../help/tour.js";
import type { Boards } from "../state/boards.js";
import type { Timeline } from "../state/timeline.js";
import { play } from "../view/icons.js";
import { counted } from "../view/numbers.js";

export interface InvitationStores {
  boards: Boards;
  timeline: Timeline;
  /** Null where there is none. */
  tour: Tour | null;
}

export const isInvited = ({ boards, timeline }: Pick<InvitationStores, "boards" | "timeline">): boolean =>
  boards.mode.value === "plan" &&
  boards.difference.value !== null &&
  timeline.lastStep.value > 0 &&
  timeline.seen.value === 0 &&
  !timeline.playing.value;

export const invitation = ({ timeline, tour }: InvitationStores): TemplateResult =>
  html`<p class="value"><button type="button" class="primary watch" @click=${(event: Event) => watch(timeline, event)}>
    ${play}Watch the ${counted(timeline.lastStep.value, "move")}</button>
    ${tour?.open.value ? html`<button type="button" class="link" @click=${() => tour.begin()}>Take the tour</button>` : nothing}</p>`;

/** The button goes with the first step: the focus moves to the bar that stops and goes back. */
function watch(timeline: Timeline, { currentTarget }: Event): void {
  const root = (currentTarget as Element).getRootNode() as Document | ShadowRoot;
  timeline.play();
  const bar = root.querySelector<HTMLElement>(".stepper .main");
  requestAnimationFrame(() => bar?.focus({ preventScroll: true }));
}
