// The question that the page itself asks: while it is open nothing takes its place, and no answer to another one counts.
import { signal } from "@preact/signals-core";
import type { Playground } from "../playground/playground.js";
import type { SharedState } from "../share/shared-state.js";
import { isOwnPage } from "./settings.js";

export class PageQuestion {
  /** The text of its document; null where the page asks nothing. */
  private readonly own = signal<string | null>(null);

  constructor(
    private readonly host: HTMLElement,
    private readonly playground: Playground,
  ) {}

  /** What is open was given by the page. */
  take(): void {
    const { exercise, problem } = this.playground;
    this.expect(exercise.posed.value?.text ?? problem.question.value?.document ?? null);
  }

  /** The question of a document is the page's, also where a link is opened first. */
  expect(text: string | null): void {
    this.own.value = text === null || isOpenToAll(this.host) ? null : this.playground.exercise.textOf(text);
  }

  /** Whether the page asks one. */
  get asked(): boolean {
    return this.own.value !== null;
  }

  /** Why no file may be opened; null where one may. */
  get refusal(): string | null {
    const posed = this.playground.exercise.posed.value;
    const open = this.own.value !== null && this.own.value === posed?.text;
    return open ? "This page asks this question: no file takes its place." : null;
  }

  /** Why a link may not be opened; null where it may. */
  refuses({ document, question }: SharedState): string | null {
    const own = this.own.value;
    const fits = own === null || document === own || question?.document === own;
    return fits ? null : "This link holds another problem than this page asks about: the page’s own question is shown.";
  }

  /** Whether the page is told of answers and scores now: not of those to a question that was put in place of its own, or tried by its author. */
  get counts(): boolean {
    const { exercise, exerciseDraft } = this.playground;
    const asked = exercise.posed.value?.text ?? null;
    if (asked !== null && asked === exerciseDraft.tried.value?.text) return false;
    return this.own.value === null || this.own.value === asked;
  }
}

/** The playground's own page opens what anybody brings, unless its address asks a question. */
const isOpenToAll = (host: HTMLElement): boolean =>
  isOwnPage(host) && !host.hasAttribute("src") && !host.hasAttribute("exercise");
