// The tour: what stands where, in five stops. It is offered until it was taken or left, and never again.
import { type ReadonlySignal, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import { rememberShown, wasShown } from "../view/once.js";

interface Stop {
  /** What it is about. */
  of: string;
  title: string;
  text: string;
}

const stops: readonly Stop[] = [
  {
    of: ".panel.actor",
    title: "The agent",
    text: "It walks to its true goal, the one with the star. The other goals are those it might have had.",
  },
  {
    of: ".panel.adversarial",
    title: "The enemy",
    text: "It is told a symbol for each move, and nothing else. Tinted are the places where the agent can be, for all it knows. It should stay in doubt.",
  },
  {
    of: ".panel.cooperative",
    title: "The friend",
    text: "It is told symbols of its own, and should understand which goal the agent is after.",
  },
  {
    of: ".panel.adversarial .verdict",
    title: "Possible and ruled out",
    text: "A goal is possible when the agent can be at it, and ruled out when nothing leads there any more or the plan is over. Choose a goal to see why it is not possible.",
  },
  {
    of: ".stepper",
    title: "Step by step",
    text: "Watch all moves, or go on and back by one. Below, you change the problem, become the agent or the enemy, and compare solvers.",
  },
];

const NAME = "tour";

export class Tour {
  private readonly stop = signal<number | null>(null);
  private readonly offered = signal(!wasShown(NAME));
  /** Whether it may be begun. */
  readonly open: ReadonlySignal<boolean> = this.offered;

  constructor(private readonly element: HTMLElement) {}

  begin(): void {
    rememberShown(NAME);
    this.offered.value = false;
    this.go(0);
  }

  /** Nothing while it is not under way. */
  card(): TemplateResult | typeof nothing {
    const at = this.stop.value;
    const stop = at === null ? undefined : stops[at];
    if (at === null || stop === undefined) return nothing;
    const last = at === stops.length - 1;
    return html`<section class="tour" role="dialog" aria-label="Tour, stop ${at + 1} of ${stops.length}: ${stop.title}"
      tabindex="-1" data-stop=${at + 1} @keydown=${(event: KeyboardEvent) => this.key(event, at)}>
      <p class="tour-head"><b>${stop.title}</b> <span>${at + 1} of ${stops.length}</span></p>
      <p>${stop.text}</p>
      <div class="actions">
        ${last ? nothing : html`<button type="button" class="small" @click=${() => this.end()}>Skip the tour</button>`}
        ${at === 0 ? nothing : html`<button type="button" class="small" @click=${() => this.go(at - 1)}>Back</button>`}
        <button type="button" class="small primary" @click=${() => (last ? this.end() : this.go(at + 1))}>${last ? "Done" : "Next"}</button>
      </div>
    </section>`;
  }

  private go(at: number): void {
    this.stop.value = at;
    // The card is drawn by then.
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        this.point(stops[at]?.of ?? "");
        this.element.querySelector<HTMLElement>(".tour")?.focus({ preventScroll: true });
      }),
    );
  }

  private end(): void {
    this.stop.value = null;
    this.point("");
    requestAnimationFrame(() =>
      this.element.querySelector<HTMLElement>(".watch, .stepper .main")?.focus({ preventScroll: true }),
    );
  }

  /** Frames a part of the playground, and brings it into view above the card. */
  private point(selector: string): void {
    for (const part of this.element.querySelectorAll("[data-tour]")) part.removeAttribute("data-tour");
    const part = selector === "" ? null : this.element.querySelector(selector);
    part?.setAttribute("data-tour", "");
    const card = this.element.querySelector(".tour")?.getBoundingClientRect();
    const place = part?.getBoundingClientRect();
    if (part == null || card === undefined || place === undefined || part.matches(".stepper")) return;
    if (place.top < 0 || place.bottom > card.top) part.scrollIntoView({ block: "start" });
  }

  private key(event: KeyboardEvent, at: number): void {
    const to: Record<string, () => void> = {
      Escape: () => this.end(),
      ArrowRight: () => (at < stops.length - 1 ? this.go(at + 1) : undefined),
      ArrowLeft: () => (at > 0 ? this.go(at - 1) : undefined),
    };
    const act = to[event.key];
    if (act === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    // Elsewhere these keys walk through the steps.
    event.preventDefault();
    event.stopPropagation();
    act();
  }
}
