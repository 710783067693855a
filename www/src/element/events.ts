// What a playground tells the page it stands in: `mo-copp-step`, `mo-copp-outcome`, `mo-copp-answer` and `mo-copp-score`.
import type { ByObserver } from "../core.js";
import type { Playground } from "../playground/playground.js";
import type { Result } from "../state/answer.js";
import type { Answered } from "../worker/protocol.js";
import type { Asking } from "./form-field.js";
import type { PageQuestion } from "./page-question.js";
import { scoreOf } from "./score.js";

/** The detail of `mo-copp-step`. */
export interface StepDetail {
  step: number;
  /** The number of the last one; while a goal is being guessed, of the furthest one seen. */
  steps: number;
  action: string | null;
  symbols: ByObserver<string | null>;
  /** Possible for each observer. */
  goals: ByObserver<string[]>;
  /** That of a plan that stops at this step; 0 while a goal is being guessed. */
  goal_difference: number;
  /** The step is the end of a plan for the true goal, where alone the page shows a goal difference. */
  ended: boolean;
}

/** The detail of `mo-copp-answer`. */
export interface AnswerDetail {
  code: string;
  /** From 0 to 1. */
  score: number | null;
}

/** The detail of `mo-copp-score`. */
export interface ScoreDetail {
  /** From 0 to 1. */
  score: number;
}

/** What is told by each event. */
interface Details {
  "mo-copp-step": StepDetail;
  "mo-copp-outcome": Answered;
  "mo-copp-answer": AnswerDetail;
  "mo-copp-score": ScoreDetail;
}

/** What a field of a form is told. */
export interface FieldTold {
  /** The code of an answer that a form is to send; null where there is none. */
  keepCode: (code: string | null) => void;
  /** Whether there is a question. */
  keepAsking: (asking: Asking) => void;
}

export class Notifier {
  private step: string | null = null;
  private result: Result | null = null;
  private score: number | null = null;
  private code: string | null = null;

  constructor(
    private readonly playground: Playground,
    private readonly element: HTMLElement,
    private readonly question: PageQuestion,
    private readonly field: FieldTold,
  ) {}

  /** Tells what has changed since the last time. */
  notify(): void {
    const { timeline, answer, boards, problem } = this.playground;
    const shown = timeline.shown.value;
    // What a question hides is not told to the page either.
    if (shown !== null && !problem.veiled.value) {
      const detail: StepDetail = {
        step: timeline.step.value,
        // Not how long the way is that somebody guesses about.
        steps: (boards.mode.value === "guess" ? timeline.seen : timeline.lastStep).value,
        action: shown.action,
        symbols: shown.symbols,
        goals: shown.goals,
        goal_difference: shown.goal_difference,
        ended: boards.ended.value,
      };
      const told = JSON.stringify(detail);
      if (told !== this.step) this.send("mo-copp-step", detail);
      this.step = told;
    }
    const outcome = answer.result.value;
    if (outcome !== null && outcome !== this.result) this.send("mo-copp-outcome", outcome.outcome);
    this.result = outcome;
    if (this.question.counts) this.notifyScore();
    this.field.keepAsking(this.question.asking);
  }

  private notifyScore(): void {
    const code = this.playground.exercise.code.value;
    if (code !== this.code) this.field.keepCode(code);
    if (code !== null && code !== this.code) this.send("mo-copp-answer", { code, score: scoreOf(this.playground) });
    this.code = code;
    const score = scoreOf(this.playground);
    if (score !== null && score !== this.score) this.send("mo-copp-score", { score });
    this.score = score;
  }

  private send<Name extends keyof Details>(name: Name, detail: Details[Name]): void {
    this.element.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
  }
}
