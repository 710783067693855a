// <mo-copp-playground>: it is drawn into a shadow root, so that no style of the page reaches what is in it, and none of
// its own the page. Only on the stand-alone page, which is the playground's own, it is drawn into the document
// (`root="page"`). docs/embedding.md lists attributes, properties, events and parts.
import { adopt, adoptAgain } from "./adopt.js";
import { keepInside } from "./form-field.js";
import { PlaygroundElement, Unfit } from "./playground-element.js";
import { followInProse } from "./prose.js";
import { Theme } from "./theme.js";
import { probe, probeStyle } from "./theme-probe.js";
import type { View } from "./view.js";

/**
 * What there is before the view: room for it, so that playgrounds that wait for their turn are not all in sight.
 *
 * What is drawn goes by the width that it has, and so has none of its own. Where the box around it is as wide as what
 * is in it, an unseen line of text gives it one: it is as long as a playground is wide, and breaks where there is less.
 * No line around the playground stands on it: what is contained and no scroll container has no baseline.
 * A page may make the host a row, a grid or a table: all of it is one box, which is as wide as the host. What would leave
 * it no room is decided here, whatever a rule of the page is for: all elements, or this one.
 *
 * Lines that the page draws under or through its text go on into all boxes in its flow, whatever these say, but not into
 * floats: what is drawn is one, as wide and as high as its ground. (Inline blocks stop them as well, and are not
 * broken into pages.)
 */
const frame = `
:host { display: block; writing-mode: horizontal-tb !important; columns: auto !important;
  contain: none !important; container-type: normal !important; }
:host([hidden]) { display: none !important; }
:host::before, :host::after { content: none !important; }
:host(:fullscreen) { overflow: auto; }
.whole { display: block; flex: 1 1 auto; grid-column: 1 / -1; place-self: start stretch; width: 100%; min-width: 0; }
.width { all: initial; display: block; contain: layout; height: 0; overflow: clip; visibility: hidden; font-size: inherit;
  word-spacing: max(10rem, min(60 * var(--mo-copp-font-size, max(1rem, 13px)), 100cqi - 2rem)); }
.width::before { content: "- -"; display: block; min-width: 10rem; font: 1px/0 sans-serif; }
.place { all: initial; display: block; visibility: inherit; height: 1px; margin-bottom: -1px; pointer-events: none; }
.whole:has(> .place:focus-visible) { outline: 3px solid var(--mo-copp-focus, Highlight); outline-offset: 2px; }
.ground { display: flow-root; }
.mo-copp-part { all: initial; display: block; visibility: inherit; pointer-events: inherit; }
.ground > .mo-copp-part { float: left; width: 100%; }
.mo-copp-part.waiting { min-height: 30rem; }
.mo-copp-part.waiting.has-poster { display: none; }
${probeStyle}
slot { display: none; }
slot.poster { display: contents; }
slot.poster ~ .ground > .has-poster:not(.waiting) > :not(.error, .failure) { display: none; }
.failure { margin: 0; padding: 0.75rem; font: 1rem / 1.45 system-ui, sans-serif; }
@media print {
  .mo-copp-part.waiting { min-height: 0; }
  .mo-copp-part.waiting::before { content: "The playground here was not loaded when the page was printed: print it again."; font: 1rem / 1.45 system-ui, sans-serif; }
}
`;

/**
 * The whole playground as one element.
 *
 * @customElement mo-copp-playground
 *
 * @attr {string} src - The address of a problem document, relative to the page.
 * @attr {string} problem - The name of a problem of the gallery.
 * @attr {string} plan - The title of one of that problem's plans, or actions separated by commas.
 * @attr {number} step - The step to begin with.
 * @attr {boolean} watch - The first problem opens at its first step, with an invitation to watch.
 * @attr {"exact"|"ip"|"satisficing"|"search"|"baseline"|"obfuscate"|"legible"} solver - The solver.
 * @attr {number} k - At least so many goals are possible for the enemy at the end.
 * @attr {number} j - At most so many goals are possible for the friend at the end.
 * @attr {string} horizon - Plans of so many actions; `any` for all lengths.
 * @attr {string} hide - Parts to leave out, separated by spaces.
 * @attr {string} exercise - The block of an exercise as JSON, for a problem whose document has none.
 * @attr {number} seed - The variant of an exercise.
 * @attr {string} student - A name whose variant of an exercise is shown.
 * @attr {string} name - The name under which a form sends the answer code.
 * @attr {boolean} required - A form is not sent before an answer was checked.
 * @attr {boolean} disabled - No answer can be given, and the form sends none.
 * @attr {"off"} link - `off`: this playground leaves the page's address alone.
 * @attr {"light"|"dark"|"auto"} theme - The colours; `auto`, as without it, follows the page.
 * @attr {"page"|"focus"|"off"} keys - Where keys walk through the steps.
 * @attr {"lazy"} loading - `lazy`: nothing is loaded before the playground is in sight or, once the page is read on, near it.
 * @attr {string} worker-url - Where the worker's script is, for pages that place it themselves.
 * @attr {string} wasm-url - Where the core is, for pages that place it themselves.
 *
 * @fires mo-copp-step - Another step is shown, or a step of other steps.
 * @fires mo-copp-outcome - A solver has answered; the detail is the outcome.
 * @fires mo-copp-answer - The answer to an exercise was checked; the detail has its code and score.
 * @fires mo-copp-score - A guess or a walk of the person has come to its end, or an answer was checked; the detail's `score` is from 0 to 1.
 *
 * @fires input - The person has changed the answer code, which is the element's value.
 * @fires change - The person has changed the answer code, which is the element's value.
 *
 * @slot - What stands for the playground until it runs, and where it cannot.
 *
 * @csspart playground - All that is drawn.
 * @csspart problem-bar - The problem's name, its plans and the way to the others.
 * @csspart toolbar - The tools that edit.
 * @csspart boards - The three boards.
 * @csspart board - Each board with its heading.
 * @csspart actor-board - The agent's board.
 * @csspart adversarial-board - The enemy's board.
 * @csspart cooperative-board - The friend's board.
 * @csspart stepper - The bar of the steps.
 * @csspart exercise - The question of an exercise, with all that belongs to it.
 * @csspart legend - What the signs mean.
 * @csspart workbench - The tabs.
 * @csspart goals - The table of goals.
 *
 * @cssprop --mo-copp-font - The font; the system's by default.
 * @cssprop --mo-copp-font-size - The size that all sizes go by; the page's root size by default.
 * @cssprop --mo-copp-gap - The room between the boards.
 * @cssprop --mo-copp-board-height - The most that a board's picture may be high.
 * @cssprop --mo-copp-paper - The ground.
 * @cssprop --mo-copp-card - The ground of boards and forms.
 * @cssprop --mo-copp-ink - Text.
 * @cssprop --mo-copp-muted - Text that stands back.
 * @cssprop --mo-copp-line - Lines between parts.
 * @cssprop --mo-copp-control - The frames of controls.
 * @cssprop --mo-copp-floor - Free cells.
 * @cssprop --mo-copp-wall - Walls.
 * @cssprop --mo-copp-enemy - The enemy.
 * @cssprop --mo-copp-enemy-tint - What the enemy believes.
 * @cssprop --mo-copp-friend - The friend.
 * @cssprop --mo-copp-friend-tint - What the friend believes.
 * @cssprop --mo-copp-focus - The ring around what has the focus.
 */
export class MoCoppPlayground extends PlaygroundElement {
  #root: HTMLElement | null = null;
  #slotted: HTMLSlotElement | null = null;
  #theme: Theme | null = null;
  /** Somebody tried to load the view again. */
  #retried = false;
  #stopFollowing: (() => void) | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#stopFollowing ??= followInProse(this, {
      wake: () => void this.show(),
      again: (name) => this.follow(name),
    });
    this.#theme?.connect();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#stopFollowing?.();
    this.#stopFollowing = null;
    this.#theme?.disconnect();
  }

  /** It has moved into another document, as from one frame to another. */
  adoptedCallback(): void {
    if (this.shadowRoot !== null) adoptAgain(this.shadowRoot);
  }

  override attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    super.attributeChangedCallback(name, before, after);
    if (name === "theme") this.#theme?.update();
  }

  protected override makeRoot(): HTMLElement {
    if (this.#root !== null) return this.#root;
    if (this.getAttribute("root") === "page") {
      this.#root = this;
      this.#theme = new Theme(this, this, false);
      return this;
    }
    const shadow = this.attachShadow({ mode: "open" });
    adopt(shadow, "frame", frame);
    const root = document.createElement("div");
    root.className = "mo-copp-part waiting";
    root.setAttribute("part", "playground");
    root.lang = "en";
    root.dir = "ltr";
    keepInside(root);
    this.#slotted = document.createElement("slot");
    this.#slotted.className = "poster";
    // The page's own children of the element stand for the picture until there is one, and where there can be none.
    const slotted = this.#slotted;
    const look = () => root.classList.toggle("has-poster", slotted.assignedNodes().some(isShown));
    slotted.addEventListener("slotchange", look);
    const width = document.createElement("div");
    width.className = "width";
    const ground = document.createElement("div");
    ground.className = "ground";
    ground.append(root);
    const whole = document.createElement("div");
    whole.className = "whole";
    whole.append(width, this.#slotted, ground);
    const theme = new Theme(this, root, true);
    shadow.append(
      whole,
      probe(() => theme.soon()),
    );
    this.#root = root;
    look();
    this.#theme = theme;
    return root;
  }

  protected override async load(): Promise<typeof View> {
    if (this.#root === this) return (await import("./view.js")).View;
    const { View, styles } = await import("./shadow-view.js");
    const shadow = this.shadowRoot;
    if (shadow !== null) for (const [name, text] of styles) adopt(shadow, name, text);
    this.#root?.replaceChildren();
    return View;
  }

  protected override shown(): void {
    super.shown();
    this.#root?.classList.remove("waiting");
    // Where nothing could be drawn, the poster stays beside the word of why, and beside nothing else.
    if (this.#slotted !== null && this.#root?.querySelector("[data-board], .stage, .exercise") !== null)
      this.#slotted.className = "";
  }

  protected override failed(error: unknown, again: () => void): void {
    const forbidden = /TrustedType/.test(String(error));
    const unfit = error instanceof Unfit;
    const retry = () => {
      this.#retried = true;
      again();
    };
    const text = document.createElement("p");
    text.className = "failure";
    text.setAttribute("role", "alert");
    if (unfit) text.textContent = error.message;
    else if (forbidden)
      text.textContent =
        "The playground cannot run here: trusted-types of the page’s content policy must allow lit-html and mo-copp.";
    else
      text.append(
        "The playground could not be loaded. Check the connection, then try again. ",
        button("Try again", retry),
      );
    // Firefox asks for no module twice that it could not load, as long as the page is open.
    if (this.#retried)
      text.append(
        " ",
        button("Load the page again", () => location.reload()),
      );
    this.#root?.replaceChildren(text);
    this.#root?.classList.remove("waiting");
    this.dataset.status = "error";
  }
}

/** Whether a child of the element is something to see. */
const isShown = (child: Node): boolean =>
  child instanceof Element ? !(child instanceof HTMLScriptElement) : child.textContent?.trim() !== "";

function button(text: string, act: () => void): HTMLButtonElement {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = text;
  made.addEventListener("click", act);
  return made;
}
