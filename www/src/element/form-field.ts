// What a form asks of a field, and what its page hears from it: whether a required answer is there, and that it changed.

/** Whether there is a question: `awaited` while that is not known, `missing` with why none came. */
export type Asking = "awaited" | "asked" | "none" | { missing: string | null };

const MISSING = "Check an answer to this question first: its code is what the form sends.";
const NO_QUESTION = "An answer is required here, and its question did not come.";

/** What helps, once it is drawn: the button that checks an answer, the way to the question, a second try. */
const helpful = [".exercise .answer button.primary", ".way-back button", ".error button.again", ".failure button"];

/** Says that a required answer is missing, where the browser points at it: at what helps, or at the place of the question. */
export class RequiredAnswer {
  /** Takes the focus while there is nothing else to take it. */
  #place: HTMLElement | null = null;

  constructor(
    private readonly element: HTMLElement,
    private readonly internals: ElementInternals,
    /** The answer is wanted: has the question drawn. */
    private readonly wake: () => void,
  ) {}

  update(isMissing: boolean, asking: Asking): void {
    // Where nothing is asked nothing can be answered.
    if (!isMissing || asking === "none") {
      this.internals.setValidity({});
      this.#place?.remove();
      this.#place = null;
      return;
    }
    const helps = this.#helps();
    this.internals.setValidity({ valueMissing: true }, messageOf(asking), helps ?? this.#placed());
    // Where the place was pointed at, what helps is pointed at in its stead.
    if (helps === null || !this.#isPointedAt) return;
    queueMicrotask(() => {
      if (this.#isPointedAt) this.internals.reportValidity();
    });
  }

  #helps(): HTMLElement | null {
    const root = this.element.shadowRoot ?? this.element;
    return helpful.map((one) => root.querySelector<HTMLElement>(one)).find((one) => one !== null) ?? null;
  }

  get #isPointedAt(): boolean {
    return this.#place !== null && this.element.shadowRoot?.activeElement === this.#place;
  }

  #placed(): HTMLElement | undefined {
    const before = this.element.shadowRoot?.querySelector(".whole > .width");
    if (this.#place === null && before) {
      this.#place = document.createElement("div");
      this.#place.className = "place";
      this.#place.tabIndex = -1;
      this.#place.lang = "en";
      this.#place.setAttribute("role", "group");
      this.#place.setAttribute("aria-label", "Question");
      this.#place.addEventListener("focus", this.wake);
      before.after(this.#place);
    }
    return this.#place ?? undefined;
  }
}

function messageOf(asking: Asking): string {
  if (typeof asking === "string") return MISSING;
  return [NO_QUESTION, ...(asking.missing === null ? [] : [asking.missing])].join(" ");
}

/** What the controls in the element tell of themselves is no word of the element's value, and stays in it. */
const ofControls = ["input", "beforeinput"] as const;

export function keepInside(root: HTMLElement): void {
  for (const type of ofControls) root.addEventListener(type, (event) => event.stopPropagation());
}

/** Says that the person has given another value, as other fields do. */
export function tellChange(element: HTMLElement): void {
  element.dispatchEvent(new Event("input", { bubbles: true, composed: true }));
  element.dispatchEvent(new Event("change", { bubbles: true }));
}
