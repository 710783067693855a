// What plans can reach: every pair of survivor counts, and the best of every length. Both follow the problem while they
// are looked at.
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals-core";
import type { LengthPoint, Progress, SolveOptions } from "../core.js";
import type { Ending } from "../worker/client.js";
import { runWithin } from "../worker/patience.js";
import { TaskRunner } from "../worker/runner.js";
import type { Form } from "./form.js";
import { lost } from "./lost.js";
import type { OpenDocument, OpenProblem } from "./open-problem.js";
import { hasAllPairs, merged, type Pairs, shortest } from "./pairs.js";
import { Stopwatch } from "./stopwatch.js";
import type { Workbench } from "./workbench.js";

export interface Lengths {
  document: OpenDocument;
  bounds: Bounds;
  points: readonly LengthPoint[];
  /** Whether every length that was asked for is there. */
  complete: boolean;
}

type Bounds = Pick<SolveOptions, "k" | "j">;
type Solved = Extract<Ending, { kind: "solved" }>["outcome"];

/** How many moves more than the shortest plan can be looked at. */
export const extras = [6, 12, 24, 48] as const;
export const initialExtra = 12;
const PATIENCE_S = 3;
/** The core looks at no more. */
const MOST_LENGTHS = 1000;

interface Stores {
  problem: Pick<OpenProblem, "document">;
  form: ReadonlySignal<Form>;
  workbench: Pick<Workbench, "tab">;
}

export class Tradeoff {
  readonly pairs = signal<Pairs | null>(null);
  readonly lengths = signal<Lengths | null>(null);
  readonly busy = signal(false);
  readonly progress = signal<Progress | null>(null);
  readonly stopwatch = new Stopwatch();
  readonly extra = signal<number>(initialExtra);
  /** What went wrong; the next change tries again. */
  readonly error = signal<string | null>(null);
  /** Something was given up since it took long. */
  readonly cut = signal(false);
  /** A worker did not stop when it was asked to, and another took its place. */
  readonly replaced = signal(false);
  private readonly patience = signal(PATIENCE_S);
  private readonly runner = new TaskRunner("later");
  /** How often it was asked to look again at the same. */
  private readonly again = signal(0);
  private run = 0;

  /** Whether what is shown is of the problem that is open. */
  readonly current: ReadonlySignal<boolean>;

  constructor({ problem, form, workbench }: Stores) {
    this.current = computed(() => this.pairs.value !== null && this.pairs.value.document === problem.document.value);
    // As text: the same bounds again are no reason to look again.
    const bounds = computed(() => {
      const { k, j } = form.value;
      return JSON.stringify({ ...(k === "" ? {} : { k: Number(k) }), ...(j === "" ? {} : { j: Number(j) }) });
    });
    effect(() => {
      const document = problem.document.value;
      if (document === null || workbench.tab.value !== "trade-off") {
        this.stop();
        return;
      }
      this.again.value;
      const asked = { bounds: JSON.parse(bounds.value) as Bounds, extra: this.extra.value };
      void this.look(document, asked, this.patience.value);
    });
  }

  /** Ends the work with what is known by then. */
  cancel(): void {
    this.runner.cancel();
  }

  lookLonger(): void {
    this.pairs.value = null;
    this.patience.value *= 10;
  }

  retry(): void {
    this.pairs.value = null;
    this.again.value += 1;
  }

  sleep(): void {
    this.stopwatch.halt();
    this.runner.sleep();
  }

  wake(): void {
    this.stopwatch.goOn();
    this.runner.wake();
  }

  private stop(): void {
    this.run += 1;
    this.runner.drop();
    this.stopwatch.stop();
    this.busy.value = false;
  }

  private async look(document: OpenDocument, asked: { bounds: Bounds; extra: number }, patience: number) {
    this.run += 1;
    const run = this.run;
    this.begin();
    const known = this.pairs.peek();
    const solve = async (options: Omit<SolveOptions, "solver">): Promise<Solved | null> => {
      const ending = await this.solve(document, { ...options, solver: "exact" }, patience);
      if (run !== this.run) return null;
      if (ending.kind === "solved" && ending.replaced) this.replaced.value = true;
      if (ending.kind === "solved") return ending.outcome;
      this.fail(ending);
      return null;
    };

    let longest = 0;
    if (known?.document === document && known.known.kind === "all") {
      longest = shortest(known.points) + asked.extra;
    } else {
      const all = await solve({ pareto: true });
      if (all === null) return;
      const points = all.pareto ?? [];
      if (hasAllPairs(all)) {
        this.pairs.value = { document, points, known: { kind: "all" } };
        longest = shortest(points) + asked.extra;
      } else {
        // Too many beliefs for plans of every length: short ones have fewer.
        this.cut.value = true;
        this.pairs.value = { document, points, known: { kind: "found" } };
        longest = Math.min(MOST_LENGTHS, (all.plan?.length ?? 0) + asked.extra);
        const some = await solve({ pareto: true, lengths: longest });
        if (some === null) return;
        this.pairs.value = {
          document,
          points: merged(points, some.pareto ?? []),
          known: hasAllPairs(some) ? { kind: "up to", moves: longest } : { kind: "found" },
        };
      }
    }
    const best = await solve({ ...asked.bounds, lengths: Math.min(MOST_LENGTHS, longest) });
    if (best === null) return;
    const points = best.lengths ?? [];
    const complete = points.length > Math.min(MOST_LENGTHS, longest);
    if (!complete) this.cut.value = true;
    this.lengths.value = { document, bounds: asked.bounds, points, complete };
    this.stop();
  }

  private begin(): void {
    this.busy.value = true;
    this.cut.value = false;
    this.replaced.value = false;
    this.error.value = null;
    this.progress.value = null;
    this.stopwatch.start();
  }

  private solve(document: OpenDocument, options: SolveOptions, patience: number): Promise<Ending> {
    return runWithin(
      this.runner,
      { kind: "solve", document: document.text, options },
      {
        milliseconds: patience * 1000,
        report: (update) => {
          if (update.kind === "progress") this.progress.value = update.progress;
        },
      },
    );
  }

  private fail(ending: Ending): void {
    this.stop();
    if (ending.kind === "refused") this.error.value = ending.message;
    if (ending.kind === "lost") this.error.value = lost(ending);
  }
}
