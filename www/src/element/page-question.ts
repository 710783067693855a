// The question that the page itself asks: while it is open nothing takes its place, and no answer to another one counts.
import { signal } from "@preact/signals-core";
import type { Playground } from "../playground/playground.js";
import type { SharedState } from "../share/shared-state.js";
import type { Asking } from "./form-field.js";
import { inline, isOwnPage } from "./settings.js";

export class PageQuestion {
  /** The text of its document; null where the page asks nothing. */
  private readonly own = signal<string | null>(null);
  /** Whether the document of the page is known: it is on its way at first, and missing where it could not be opened. */
  private readonly document = signal<"awaited" | "missing" | "known">("awaited");

  constructor(
    private readonly host: HTMLElement,
    private readonly playground: Playground,
  ) {}

  /** What the page gives is being opened. */
  begin(): void {
    if (!this.isOpen) this.document.value = "awaited";
  }

  /** What is open was given by the page. */
  take(): void {
    const { exercise, problem } = this.playground;
    this.keep(exercise.posed.value?.text ?? problem.question.value?.document ?? null);
    this.document.value = "known";
  }

  /** The question of a document is the page's, also where a link is opened first; null where the document is missing. */
  expect(text: string | null): void {
    this.keep(text);
    if (text === null) this.miss();
  }

  /** A document without a question needs no guard, also while it is solved. */
  read(text: string): void {
    if (isObject(text) && this.playground.exercise.textOf(text) === null) this.document.value = "known";
  }

  /** A link to the page's own question was opened. */
  arrive(): void {
    if (this.document.value === "awaited") this.document.value = "known";
  }

  /** What the page gives could not be opened. */
  miss(): void {
    if (this.document.value === "awaited") this.document.value = "missing";
  }

  private keep(text: string | null): void {
    this.own.value = text === null || isOpenToAll(this.host) ? null : this.playground.exercise.textOf(text);
  }

  /** Whether the page asks one. */
  get asked(): boolean {
    return this.own.value !== null;
  }

  /** What a form is told: whether there is a question that asks for an answer. */
  get asking(): Asking {
    const { answer, exercise } = this.playground;
    if (exercise.posed.value !== null || this.asked) return "asked";
    if (this.document.value === "missing") return { missing: answer.error.value };
    return this.document.value === "known" && !exercise.opening.value ? "none" : "awaited";
  }

  /** Why no file may be opened; null where one may. */
  get refusal(): string | null {
    if (this.isOpen) return "This page asks this question: no file takes its place.";
    return this.isAwaited ? "This page’s own problem is still being opened: no file takes its place." : null;
  }

  /** Why a link may not be opened; null where it may. */
  refuses({ document, question }: SharedState): string | null {
    const own = this.own.value;
    if (own === null && this.isAwaited)
      return "This page’s own problem is still being opened: follow the link again after that.";
    const fits = own === null || document === own || question?.document === own;
    return fits ? null : "This link holds another problem than this page asks about: the page’s own question is shown.";
  }

  /** Whether the page is told of answers and scores now: not of those to a question that was put in place of its own, or tried by its author. */
  get counts(): boolean {
    const { exercise, exerciseDraft } = this.playground;
    const asked = exercise.posed.value?.text ?? null;
    if (asked !== null && asked === exerciseDraft.tried.value?.text) return false;
    if (this.own.value !== null) return this.own.value === asked;
    return this.document.value === "known" || !mayAsk(this.host);
  }

  private get isOpen(): boolean {
    return this.own.value !== null && this.own.value === this.playground.exercise.posed.value?.text;
  }

  private get isAwaited(): boolean {
    return this.document.value === "awaited" && mayAsk(this.host);
  }
}

/** The playground's own page opens every file and link, unless its address asks a question. */
const isOpenToAll = (host: HTMLElement): boolean =>
  isOwnPage(host) && !host.hasAttribute("src") && !host.hasAttribute("exercise");

/** Whether the page gives a document of its own, which may be a question. */
const mayAsk = (host: HTMLElement): boolean =>
  !isOpenToAll(host) && (host.hasAttribute("src") || host.hasAttribute("exercise") || inline(host) !== null);

function isObject(text: string): boolean {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === "object" && value !== null;
  } catch {
    return false;
  }
}
