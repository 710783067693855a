// The custom element: its attributes and its life in the page. What it shows comes with the view, which is loaded when
// the element nears what is seen of the page. This file needs no document to be loaded.

import type { ProblemDocument } from "../problem/types.js";
import type { SharedState } from "../share/shared-state.js";
import type { Answered } from "../worker/protocol.js";
import { nextTurn } from "../worker/turn.js";
import { type Asked, count, overtakenBy } from "./asked.js";
import { followed, isOn, no, propertiesAlone } from "./attributes.js";
import { type Asking, RequiredAnswer, tellChange } from "./form-field.js";
import type { Wanted } from "./given.js";
import { parsed, textOf } from "./parsed.js";
import { reflect, reflected } from "./reflected.js";
import { signs } from "./signs.js";
import type { ElementSolveOptions } from "./solve-options.js";
import type { PngOptions, SvgOptions } from "./svg-options.js";
import type { View } from "./view.js";
import { whenNear, whenParsed } from "./when.js";

const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;

/** Settles when the playground that came last in the page has begun, or failed to. */
let lastBegun: Promise<void> = Promise.resolve();

/** The page is none that a playground can be drawn in; the message says why. */
export class Unfit extends Error {}

export abstract class PlaygroundElement extends Base {
  /** A form sends the code of the last answer to an exercise. */
  static readonly formAssociated = true;

  static get observedAttributes(): string[] {
    return [...followed, ...propertiesAlone, "required", "disabled"];
  }

  /** Settles once the first picture is drawn, or cannot be. */
  readonly ready: Promise<this>;

  // Private names: a framework sets a property wherever the element has one of an attribute's name.
  #view: View | null = null;
  #settleReady: () => void = () => {};
  #settleDrawn: () => void = () => {};
  readonly #drawn: Promise<void>;
  /** What was set before there was a view. */
  readonly #wanted: Wanted = { document: null, state: null };
  #begun: Promise<void> | null = null;
  #stopWaiting: (() => void) | null = null;

  /** What a form is told by. */
  readonly #internals: ElementInternals | undefined;
  readonly #answer: RequiredAnswer | undefined;
  #asking: Asking = "awaited";
  /** The code that a form sends; null where there is none. */
  #code: string | null = null;
  #isDisabled = false;
  /** What was asked for until now. */
  readonly #asked: Asked = { problems: 0, questions: 0 };
  /** The page's problem at which the person was at work last; null before that. */
  #touched: number | null = null;

  constructor() {
    super();
    this.#internals = this.attachInternals?.();
    if (this.#internals !== undefined) this.#answer = new RequiredAnswer(this, this.#internals, () => void this.show());
    this.#validate();
    const touch = () => {
      this.#touched = this.#asked.problems;
    };
    for (const sign of signs) this.addEventListener(sign, touch, true);
    this.#drawn = new Promise((resolve) => {
      this.#settleDrawn = resolve;
    });
    this.ready = new Promise((resolve) => {
      this.#settleReady = () => resolve(this);
    });
  }

  static {
    reflect(PlaygroundElement.prototype);
  }

  /** What draws the playground, for this project's own tests: no part of the element that stays as it is. */
  get [Symbol.for("mo-copp view")](): View | null {
    return this.#view;
  }

  /**
   * The problem document that is open, or is being opened: a copy, of which a change changes nothing before it is set.
   * Set, as an object or as its text, it is opened.
   */
  get document(): ProblemDocument | null {
    return this.#view === null ? (parsed(this.#wanted.document) as ProblemDocument | null) : this.#view.document;
  }

  set document(value: ProblemDocument | string | null) {
    if (value === null || value === undefined) return;
    const given = textOf("document", value);
    if ("fault" in given) this.#refuse(given.fault);
    else {
      this.#asked.problems += 1;
      if (this.#view === null) Object.assign(this.#wanted, { document: given.text, state: null, fault: null });
      else void this.#view.openDocument(given.text);
    }
  }

  /** All that a link would hold: problem, options, plan, step, open tab. Kept and set again, the playground is as it was. */
  get state(): SharedState | null {
    if (this.#view !== null) return this.#view.state;
    return this.#wanted.state === null ? null : JSON.parse(this.#wanted.state);
  }

  set state(value: SharedState | null) {
    if (value === null || value === undefined) return;
    const given = textOf("state", value);
    if ("fault" in given) this.#refuse(given.fault);
    else {
      this.#asked.problems += 1;
      if (this.#view === null) Object.assign(this.#wanted, { document: null, state: given.text, fault: null });
      else void this.#view.openState(given.text);
    }
  }

  /** The form that the element is a field of. */
  get form(): HTMLFormElement | null {
    return this.#internals?.form ?? null;
  }

  /** As of a field: the element's own name. */
  get type(): string {
    return this.localName;
  }

  /** The code of the last answer that was checked, which the form sends; empty while there is none. */
  get value(): string {
    return this.#code ?? "";
  }

  /** Whether a required answer is missing. */
  get validity(): ValidityState | undefined {
    return this.#internals?.validity;
  }

  /** What is said of a required answer that is missing. */
  get validationMessage(): string {
    return this.#internals?.validationMessage ?? "";
  }

  /** Whether the form looks at the element before it is sent. */
  get willValidate(): boolean {
    return this.#internals?.willValidate ?? false;
  }

  /** Whether there is an answer code, or none is required. */
  checkValidity(): boolean {
    return this.#internals?.checkValidity() ?? true;
  }

  /** The same; what is missing is said to whoever reads the page. */
  reportValidity(): boolean {
    return this.#internals?.reportValidity() ?? true;
  }

  /** What was set can't be used: what was there stays. */
  #refuse(fault: string): void {
    if (this.#view === null) this.#wanted.fault = fault;
    else this.#view.refuse(fault);
  }

  /** Shows a step; one beyond the last is the last. Rejects with a sentence where that is no whole number from 0. */
  async goTo(step: number): Promise<void> {
    (await this.#whenDrawn()).goTo(step);
  }

  /**
   * Solves the problem that was asked for when this was called. Rejects with a sentence where another problem or question
   * was asked for since, the options do not fit or the solver was lost.
   */
  async solve(options: ElementSolveOptions | null = {}): Promise<Answered> {
    const before = { ...this.#asked };
    const view = await this.#whenDrawn();
    const overtaken = overtakenBy(before, this.#asked);
    if (overtaken !== null) throw new Error(overtaken);
    return view.solve(options ?? {});
  }

  /**
   * The step shown as the text of an SVG picture, the same as `mo-copp picture` writes; with `walk` all steps, animated.
   * Rejects with a sentence where there is nothing to draw, or an option does not fit.
   *
   * @param options - `step`; `walk` and `milliseconds`; `board`; `captions`; `theme`; `true_goal`, whether the true goal is
   * marked; `ended`, whether the agent stops where the plan ends.
   */
  async toSVG(options: SvgOptions | null = {}): Promise<string> {
    return (await this.#whenDrawn()).toSVG(options ?? {});
  }

  /**
   * The step shown as a PNG, the picture of `toSVG` at twice its size. Rejects with a sentence where there is nothing to
   * draw, an option does not fit, or the page's content policy lets no picture be read.
   */
  async toPNG(options: PngOptions | null = {}): Promise<Blob> {
    return (await this.#whenDrawn()).toPNG(options ?? {});
  }

  /** What was set before is there. */
  async #whenDrawn(): Promise<View> {
    if (this.#view === null && !this.isConnected)
      throw new Error("The playground is not in the page yet: nothing is drawn before.");
    await this.show();
    if (this.#view === null) throw new Error("The playground could not be loaded.");
    const view = this.#view;
    await this.#drawn;
    await view.settled();
    return view;
  }

  /** Makes what the playground is drawn into. */
  protected abstract makeRoot(): HTMLElement;

  /** Loads what draws the playground. */
  protected abstract load(): Promise<typeof View>;

  /** The view could not be loaded; `again` tries once more. */
  protected abstract failed(error: unknown, again: () => void): void;

  /** There is a picture, or word of why there is none. */
  protected shown(): void {
    this.#validate();
    this.#settleDrawn();
    this.#settleReady();
  }

  connectedCallback(): void {
    this.#takeEarlier();
    this.dataset.status ??= "idle";
    if (this.#view !== null) {
      this.#view.connect();
      return;
    }
    const root = this.makeRoot();
    this.#validate();
    this.#stopWaiting?.();
    // What is around the picture has the picture's size also where the element itself is clipped to none.
    const around = root.closest(".whole") ?? this;
    this.#stopWaiting = this.#isLazy ? whenNear(around, () => void this.show()) : null;
    if (!this.#isLazy) void this.show();
  }

  get #isLazy(): boolean {
    return this.getAttribute("loading") === "lazy";
  }

  disconnectedCallback(): void {
    this.#stopWaiting?.();
    this.#stopWaiting = null;
    this.#view?.disconnect();
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after) return;
    if (name === "required") this.#validate();
    // For the browser, which disables fields, any value of it says yes.
    if (name === "disabled" && after === no) this.removeAttribute(name);
    else if (name !== "disabled") this.follow(name);
  }

  /** Does what an attribute says. */
  protected follow(name: string): void {
    if (name === "loading" && this.#stopWaiting !== null && !this.#isLazy) void this.show();
    // An address is also taken away because another one was set: that one is what is asked for.
    const byPage = this.#view?.attributeChanged(name) ?? true;
    if (byPage) count(this.#asked, name);
  }

  /** Loads the view and has it draw, where that has not been done. */
  protected show(): Promise<void> {
    this.#stopWaiting?.();
    this.#stopWaiting = null;
    if (this.#begun !== null) return this.#begun;
    const begun = this.#begin(lastBegun);
    lastBegun = begun.catch(() => undefined);
    this.#begun = begun.catch((error: unknown) => {
      this.#begun = null;
      this.failed(error, () => void this.show());
      this.#validate();
      this.#settleReady();
      console.error(error);
    });
    return this.#begun;
  }

  /** The first of a page goes first, whichever is loaded first: the page's address and keys are its own. */
  async #begin(earlier: Promise<void>): Promise<void> {
    // What draws the playground writes HTML, which such a page reads as XML.
    if (document.contentType !== "text/html")
      throw new Unfit(
        `The playground cannot be drawn in a page that is sent as ${document.contentType}; expected text/html.`,
      );
    // The first picture is a turn of its own, not the end of the one that reads the page's code.
    await Promise.all([whenParsed(), nextTurn()]);
    const [Loaded] = await Promise.all([this.load(), earlier]);
    const told: ConstructorParameters<typeof View>[2] = {
      shown: () => this.shown(),
      keepCode: (code) => this.#keepCode(code),
      keepAsking: (asking) => this.#keepAsking(asking),
    };
    this.#view = new Loaded(this, this.makeRoot(), told, this.#wanted);
    this.#view.disable(this.#isDisabled);
    if (this.isConnected) this.#view.connect();
  }

  /** The form is reset: it sends no code until another answer is checked. Attempts that were made stay made. */
  formResetCallback(): void {
    this.#touched = null;
    this.#keepCode(null);
  }

  /** The element is disabled, by its attribute or by a fieldset around it. */
  formDisabledCallback(isDisabled: boolean): void {
    this.#isDisabled = isDisabled;
    this.#view?.disable(isDisabled);
  }

  #keepCode(code: string | null): void {
    const changed = code !== this.#code;
    this.#code = code;
    this.#internals?.setFormValue(code);
    this.#validate();
    // What a page sets, or what it keeps from an earlier visit, is no change for it.
    if (changed && this.#touched === this.#asked.problems) tellChange(this);
  }

  #keepAsking(asking: Asking): void {
    if (JSON.stringify(asking) === JSON.stringify(this.#asking)) return;
    this.#asking = asking;
    this.#validate();
  }

  #validate(): void {
    this.#answer?.update(isOn(this, "required") && this.#code === null, this.#asking);
  }

  /** What a script set before the element was one: then it hides what the element does with it. */
  #takeEarlier(): void {
    for (const name of [...reflected, ...propertiesAlone]) {
      if (!Object.hasOwn(this, name)) continue;
      const value: unknown = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
  }
}
