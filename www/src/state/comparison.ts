// All solvers on the problem shown, one after another, beside what is solved live.
import { batch, computed, effect, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Progress, SolveOptions } from "../core.js";
import type { Ending } from "../worker/client.js";
import { runWithin } from "../worker/patience.js";
import { TaskRunner } from "../worker/runner.js";
import type { Answer, Result } from "./answer.js";
import { emptyForm, type Form, optionsOf, solvers } from "./form.js";
import { lost } from "./lost.js";
import type { OpenDocument, OpenProblem } from "./open-problem.js";
import { Stopwatch } from "./stopwatch.js";

export interface Entrant {
  title: string;
  chosen: Pick<Form, "solver"> & Partial<Pick<Form, "encoding">>;
  /** What should be known before it is waited for. */
  note?: string;
}

/** In the order they run: the slow one last. */
export const entrants: readonly Entrant[] = [
  { title: solvers.exact.title, chosen: { solver: "exact" } },
  { title: "Integer program, belief flow", chosen: { solver: "ip", encoding: "belief-flow" } },
  { title: solvers.satisficing.title, chosen: { solver: "satisficing" } },
  { title: solvers.search.title, chosen: { solver: "search" } },
  { title: solvers.baseline.title, chosen: { solver: "baseline" } },
  { title: solvers.obfuscate.title, chosen: { solver: "obfuscate" } },
  { title: solvers.legible.title, chosen: { solver: "legible" } },
  { title: "Integer program, paper", chosen: { solver: "ip", encoding: "paper" }, note: "slow" },
];

/** The seconds that each may take; the last is without end. */
export const patiences = [2, 10, 60, Number.POSITIVE_INFINITY] as const;
export const initialPatience = 10;

export interface Row {
  entrant: Entrant;
  state: "waiting" | "running" | "answered" | "failed" | "left out";
  result?: Result;
  /** Why it was ended before its own end. */
  ended?: "skipped" | "cancelled" | "out of time";
  seconds?: number;
  message?: string;
}

interface Stores {
  problem: Pick<OpenProblem, "document">;
  form: ReadonlySignal<Form>;
  answer: Pick<Answer, "optimum">;
}

export type Bounds = Pick<Form, "k" | "j">;

interface Asked {
  document: OpenDocument;
  chosen: string;
  /** What solvers were asked for, as far as they read it. */
  numbers: ReturnType<typeof numbersOf>;
}

export class Comparison {
  readonly rows = signal<readonly Row[]>(entrants.map((entrant) => ({ entrant, state: "waiting" })));
  readonly running = signal(false);
  /** It was ended before every solver had its turn. */
  readonly cancelled = signal(false);
  readonly progress = signal<Progress | null>(null);
  readonly stopwatch = new Stopwatch();
  readonly patience = signal<number>(initialPatience);
  /** Where no bound was chosen, solvers are asked for what the best plan reaches: some have nothing to keep to without. */
  readonly bounded = signal(true);
  /** What was compared: null before the first time. */
  readonly asked = signal<Asked | null>(null);
  /** What the best plan reaches, where no bound was chosen. */
  readonly suggested: ReadonlySignal<Bounds | null> = computed(() => {
    const { k, j } = this.stores.form.value;
    const goals = this.stores.answer.optimum.value?.outcome.goals;
    if (k !== "" || j !== "" || goals === undefined || goals === null) return null;
    return { k: String(goals.adversarial.length), j: String(goals.cooperative.length) };
  });
  private readonly runner = new TaskRunner("later");
  private ended: Row["ended"];

  readonly started: ReadonlySignal<boolean> = computed(() => this.asked.value !== null);
  /** What is shown belongs to an earlier problem, or to other bounds. */
  readonly outdated: ReadonlySignal<boolean> = computed(() => {
    const asked = this.asked.value;
    const document = this.stores.problem.document.value;
    return asked !== null && (asked.document !== document || asked.chosen !== this.chosen());
  });

  constructor(private readonly stores: Stores) {
    effect(() => {
      if (this.outdated.value) this.drop();
    });
  }

  async start(): Promise<void> {
    const document = this.stores.problem.document.value;
    if (document === null || this.running.peek()) return;
    const suggested = this.bounded.value ? this.suggested.value : null;
    const numbers = { ...numbersOf(this.stores.form.value), ...suggested };
    const asked = { document, chosen: this.chosen(), numbers };
    batch(() => {
      this.cancelled.value = false;
      this.asked.value = asked;
      this.running.value = true;
      this.rows.value = entrants.map((entrant) => ({ entrant, state: "waiting" }));
    });
    let index = -1;
    for (const { chosen } of entrants) {
      index += 1;
      if (this.cancelled.peek()) break;
      const options = optionsOf({ ...emptyForm, ...numbers, ...chosen });
      if (typeof options === "string") this.change(index, { state: "failed", message: options });
      else await this.runOne(index, document, options);
      // Another comparison may have taken its place.
      if (this.asked.peek() !== asked) return;
    }
    batch(() => {
      this.running.value = false;
      this.rows.value = this.rows.value.map((row) => (row.state === "waiting" ? { ...row, state: "left out" } : row));
    });
  }

  /** Ends the solver at work, with the best it has, and goes on with the next. */
  skip(): void {
    this.end("skipped");
  }

  /** Ends the solver at work, with the best it has, and runs no other. */
  cancel(): void {
    this.cancelled.value = true;
    this.end("cancelled");
  }

  /** What was chosen of what solvers are asked for. */
  private chosen(): string {
    return JSON.stringify([numbersOf(this.stores.form.value), this.bounded.value]);
  }

  private end(how: Row["ended"]): void {
    this.ended = how;
    this.runner.cancel();
  }

  sleep(): void {
    this.stopwatch.halt();
    this.runner.sleep();
  }

  wake(): void {
    this.stopwatch.goOn();
    this.runner.wake();
  }

  /** The answers are no longer of use. */
  private drop(): void {
    if (!this.running.peek()) return;
    this.cancelled.value = true;
    this.runner.drop();
  }

  private async runOne(index: number, document: OpenDocument, options: SolveOptions): Promise<void> {
    this.ended = undefined;
    this.change(index, { state: "running" });
    this.progress.value = null;
    this.stopwatch.start();
    const ending = await runWithin(
      this.runner,
      { kind: "solve", document: document.text, options },
      {
        milliseconds: this.patience.peek() * 1000,
        report: (update) => {
          if (update.kind === "progress") this.progress.value = update.progress;
          if (update.kind === "waiting") this.progress.value = null;
          // Before, the worker was still loading, or another task had it.
          if (update.kind === "started") this.stopwatch.start();
        },
        over: () => {
          this.ended ??= "out of time";
        },
      },
    );
    this.change(index, rowOf(ending, options, this.stopwatch.stop(), this.ended));
  }

  private change(index: number, change: Partial<Row>): void {
    this.rows.value = this.rows.value.map((row, at) => (at === index ? { ...row, ...change } : row));
  }
}

function rowOf(
  ending: Ending,
  options: SolveOptions,
  passed: number,
  ended: Row["ended"],
): Partial<Row> & Pick<Row, "state"> {
  if (ending.kind === "solved") {
    const { outcome } = ending;
    const unfinished = outcome.status === "feasible" || outcome.status === "limit";
    return {
      state: "answered",
      result: { options, outcome },
      seconds: outcome.stats.seconds ?? passed,
      ...(unfinished && ended !== undefined ? { ended } : {}),
    };
  }
  if (ending.kind === "refused") return { state: "failed", message: ending.message };
  if (ending.kind === "lost") return { state: "failed", message: lost(ending) };
  return { state: "left out" };
}

const numbersOf = ({ k, j, horizon, horizonStep }: Form) => ({ k, j, horizon, horizonStep });
