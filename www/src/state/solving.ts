// Solving the open problem: at once with every change, or with the solver chosen when it is asked for.
import { batch, type Signal } from "@preact/signals-core";
import type { SolveOptions } from "../core.js";
import { afterPicture } from "../view/after-picture.js";
import type { Ending } from "../worker/client.js";
import type { News } from "../worker/pool.js";
import type { Task } from "../worker/protocol.js";
import { TaskRunner } from "../worker/runner.js";
import type { Answer } from "./answer.js";
import type { Boards } from "./boards.js";
import { Coalesce } from "./coalesce.js";
import { exactOptions, type Form, optionsOf } from "./form.js";
import { isMissing } from "./lost.js";
import { fitted } from "./numbers.js";
import type { OpenDocument, OpenProblem } from "./open-problem.js";
import { type OpeningAnswer, openingAnswer } from "./opening-answer.js";
import type { At, Timeline } from "./timeline.js";

/** What takes longer is seen to take long, and can be cancelled. */
const SLOW_MS = 300;

/** Why a problem is not solved. */
export const CLOSED = "The solvers are closed until the question that this problem belongs to is answered.";

export interface Job {
  document: OpenDocument;
  options: SolveOptions;
  /** Which step to show then. */
  at: At;
}

interface Stores {
  problem: OpenProblem;
  boards: Boards;
  timeline: Timeline;
  answer: Answer;
  form: Signal<Form>;
}

export class Solving {
  private readonly problem: OpenProblem;
  private readonly boards: Boards;
  private readonly timeline: Timeline;
  private readonly answer: Answer;
  private readonly form: Signal<Form>;
  private readonly runner = new TaskRunner("now");
  /** For short questions while the other solves. */
  private readonly aside = new TaskRunner("now");
  private readonly live = new Coalesce<Job>((job) => this.perform(job));
  /** What the best possible was asked for last. */
  private asked = "";
  /** How often something was to be solved. */
  private begun = 0;

  constructor({ problem, boards, timeline, answer, form }: Stores) {
    this.problem = problem;
    this.boards = boards;
    this.timeline = timeline;
    this.answer = answer;
    this.form = form;
  }

  /** Has a worker load the core, for the problem that will come. */
  prepare(): void {
    this.runner.prepare();
  }

  /**
   * Changes what is asked of the solver. The best possible follows at once, whatever the solver: what it is depends on
   * the bounds.
   */
  edit(change: Partial<Form>): void {
    this.form.value = { ...this.form.value, ...change };
    const document = this.problem.newest;
    const asked = JSON.stringify(exactOptions(this.form.value));
    const wanted = this.form.value.solver === "exact" && this.answer.result.value?.options.solver !== "exact";
    if (document !== null && (wanted || asked !== this.asked)) this.follow(document);
  }

  /** Runs the solver that was chosen. Resolves to how that ended; null where nothing was begun, for which a message says why. */
  async solve(at: At = "end"): Promise<Ending | null> {
    const document = this.problem.newest;
    if (document === null) return null;
    if (document.closed) {
      this.remark(CLOSED);
      return null;
    }
    this.live.clear();
    const options = optionsOf(this.form.value);
    if (typeof options === "string") {
      this.refuse(options);
      return null;
    }
    this.answer.ran.value = options.solver;
    this.begin();
    return this.perform({ document, options, at });
  }

  /** Solves a document that is being opened; `exact` is what the best possible of it is asked for. */
  async open(document: OpenDocument, options: SolveOptions, exact: SolveOptions, at: At): Promise<void> {
    this.asked = JSON.stringify(exact);
    this.begin();
    const job = { document, options, at };
    const known = this.problem.document.value === null ? openingAnswer(document.text, options) : null;
    if (known === null || document.closed) await this.perform(job);
    else this.openKnown(job, known);
  }

  /** Solves an edit; of many in short time only the last. */
  follow(document: OpenDocument): void {
    this.timeline.pause();
    const options = exactOptions(this.form.value);
    if (typeof options === "string") {
      this.refuse(options);
      return;
    }
    this.asked = JSON.stringify(options);
    this.begin();
    this.live.ask({ document, options, at: "same" });
  }

  /** Edits that wait to be solved are given up for what comes now. */
  clear(): void {
    this.live.clear();
  }

  /** Ends the solve under way; the best plan found so far is kept. */
  cancel(): void {
    this.runner.cancel();
  }

  /** A short question about a document; a solve under way goes on. */
  ask(task: Task): Promise<Ending> {
    return (this.answer.status.value === "solving" ? this.aside : this.runner).run(task);
  }

  /** Says that something can't be used, and leaves the rest as it is. `again`: what may work the next time. */
  refuse(message: string, again: (() => void) | null = null): void {
    this.runner.drop();
    this.problem.giveUp();
    this.answer.fail({ kind: "refused", message }, again);
  }

  /** Says why something was not done; what is open and under way goes on. */
  remark(message: string): void {
    this.answer.remark(message);
  }

  sleep(): void {
    this.runner.sleep();
    this.aside.sleep();
  }

  wake(): void {
    this.runner.wake();
    this.aside.wake();
  }

  private begin(): void {
    this.begun += 1;
    this.timeline.pause();
    this.answer.begin();
  }

  /** Shows an answer that came with the page, and has the core work it out as well. */
  private openKnown(job: Job, known: OpeningAnswer): void {
    this.settle(job, known);
    void this.confirm(job);
  }

  /** What the core says then is known but for whether it is there at all: where it is not, that is said before it is needed. */
  private async confirm({ document, options }: Job): Promise<void> {
    const { begun } = this;
    await afterPicture();
    // What is asked by then asks the core as well, and must not be given up for this.
    if (begun !== this.begun || this.runner.busy) return;
    const ending = await this.runner.run({ kind: "solve", document: document.text, options });
    if (begun === this.begun) this.failed(ending);
  }

  private async perform(job: Job): Promise<Ending> {
    const { document, options } = job;
    if (document.closed) return this.show(job);
    const { boards, answer } = this;
    const mode = boards.mode.value;
    answer.progress.value = null;
    // The worker itself can say nothing in the middle of a long piece of work.
    const waiting = setTimeout(() => {
      answer.slow.value = true;
    }, SLOW_MS);
    const ending = await this.runner.run({ kind: "solve", document: document.text, options }, (news) =>
      this.tell(job, news),
    );
    clearTimeout(waiting);
    if (ending.kind === "refused" && this.refit(document)) return ending;
    if (ending.kind !== "solved") return this.failed(ending);
    this.settle(job, ending, mode);
    return ending;
  }

  /** `mode`: what was shown when the solver was asked. */
  private settle({ document, options, at }: Job, { scene, outcome, trace }: OpeningAnswer, mode = "plan"): void {
    const { boards, answer } = this;
    batch(() => {
      const changed = this.take(document, scene);
      answer.take({ options, outcome }, trace, this.live.waits);
      // A game that was begun meanwhile goes on.
      const played = !changed && mode === "plan" && boards.mode.value !== "plan";
      if (!played) boards.showAnswer(trace, outcome.plan !== null, at);
    });
  }

  /** Shows a problem that is not to be solved. */
  private async show({ document, at }: Job): Promise<Ending> {
    const ending = await this.runner.run({ kind: "begin", document: document.text });
    if (ending.kind !== "begun") return this.failed(ending);
    batch(() => {
      this.take(document, ending.scene);
      this.answer.rest(ending.start);
      this.boards.showAnswer(ending.start, false, at);
    });
    return ending;
  }

  private tell({ document, at }: Job, news: News): void {
    const { problem, boards, answer } = this;
    if (news.kind === "progress") answer.progress.value = news.progress;
    if (news.kind !== "opened") return;
    batch(() => {
      answer.slow.value = true;
      if (problem.document.value === document) return;
      this.take(document, news.scene);
      answer.forget(news.start);
      boards.showAnswer(news.start, false, at);
    });
  }

  private take(document: OpenDocument, scene: Parameters<OpenProblem["take"]>[1]): boolean {
    if (!this.problem.take(document, scene)) return false;
    this.answer.optimum.value = null;
    this.boards.story.forget();
    return true;
  }

  /** Bounds that ask for more goals than an edit has left are brought down, and the edit is solved with those. */
  private refit(document: OpenDocument): boolean {
    const scene = this.problem.scene.value;
    if (this.problem.document.value !== document || scene === null) return false;
    const change = fitted(this.form.value, scene);
    if (change === null) return false;
    this.form.value = { ...this.form.value, ...change };
    this.follow(document);
    return true;
  }

  private failed(ending: Ending): Ending {
    if (ending.kind === "refused" || ending.kind === "lost") this.problem.giveUp();
    this.answer.fail(ending, isMissing(ending) ? () => void this.solve() : null);
    return ending;
  }
}
