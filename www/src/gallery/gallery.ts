// Which problem of the gallery is open, and opening another.
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import { exampleDocument } from "../problem/example.js";
import { sameProblem } from "../problem/same.js";
import type { DeliveryDocument, ProblemDocument } from "../problem/types.js";
import type { Answer } from "../state/answer.js";
import type { Boards } from "../state/boards.js";
import type { Edits } from "../state/edits.js";
import type { OpenDocument, OpenProblem } from "../state/open-problem.js";
import type { Plans } from "../state/plans.js";
import type { Solving } from "../state/solving.js";
import { brief } from "../view/names.js";
import { type Entry, entries, type NamedPlan } from "./entries.js";

interface GalleryStores {
  problem: OpenProblem;
  boards: Boards;
  answer: Answer;
  edits: Edits;
  plans: Plans;
  solving: Solving;
}

export class Gallery {
  /** The documents that are loaded, by name: at first the one that the page begins with. */
  readonly documents = signal<ReadonlyMap<string, OpenDocument>>(new Map([opened("eight-by-eight", exampleDocument)]));
  readonly menuOpen = signal(false);

  /** The entry that is open, as it is in the gallery; null for any other problem. */
  readonly current: ReadonlySignal<Entry | null> = computed(() => this.entryOf(this.playground.problem.document.value));

  /** What files of the problem that is open are called, without their ending. */
  readonly fileName: ReadonlySignal<string> = computed(() => this.current.value?.name ?? "problem");

  private loading: Promise<void> | undefined;

  constructor(private readonly playground: GalleryStores) {}

  /** Loads all documents, once. */
  load(): Promise<void> {
    this.loading ??= import("./documents.js").then(
      ({ documents }) => {
        this.documents.value = new Map([...documents].map(([name, text]) => opened(name, text)));
      },
      () => {
        this.loading = undefined;
      },
    );
    return this.loading;
  }

  async open(name: string, at: "first" | "end" = "end"): Promise<boolean> {
    if (!this.documents.value.has(name)) await this.load();
    const document = this.documents.value.get(name);
    if (document !== undefined) return this.playground.edits.open(document.text, {}, "exact", at);
    const known = entries.some((entry) => entry.name === name);
    this.playground.solving.refuse(
      known
        ? "The gallery could not be loaded. Check the connection, then try again."
        : `There is no problem called “${brief(name)}” in the gallery; expected ${entries.map((entry) => entry.name).join(", ")}.`,
      known ? () => void this.open(name, at) : null,
    );
    return false;
  }

  /** Opens the next problem of the gallery, or the one before: `way` is 1 or −1. */
  turn(way: number): Promise<boolean> {
    // What was edited is a neighbour of the others still.
    const value = this.current.value ?? this.entryOf(this.playground.problem.origin.value);
    const at = value === null ? -1 : entries.indexOf(value);
    const from = at === -1 && way < 0 ? 0 : at;
    return this.open(entries[(from + way + entries.length) % entries.length]?.name ?? "");
  }

  /** Shows a named plan of the entry that is open. */
  async show({ title, plan, trueGoal }: NamedPlan, at: "first" | "end" = "end"): Promise<void> {
    const document = this.playground.problem.document.value;
    if (document === null) return;
    const wanted = withTrueGoal(document.value, trueGoal);
    if (sameProblem(wanted, document.value)) {
      if (plan === undefined) this.showBest();
      else await this.playground.plans.show([...plan], title, () => true, at);
    } else {
      this.playground.edits.apply(wanted);
    }
  }

  /** Whether this is the named plan that is shown. */
  shows({ title, plan, trueGoal }: NamedPlan): boolean {
    const value = this.playground.problem.document.value?.value;
    const { chosen, disguise, mode } = this.playground.boards;
    // Where a guess was made, the plan shown is that of the goal drawn.
    if (value === undefined || mode.value !== "plan" || disguise.value !== null) return false;
    if (!sameProblem(withTrueGoal(value, trueGoal), value)) return false;
    return plan === undefined ? chosen.value === null && this.isBest() : chosen.value === title;
  }

  /** Whether what was solved last is the best of all plans, not of those within bounds or of another solver. */
  private isBest(): boolean {
    const { solver, k, j, horizon } = this.playground.answer.result.value?.options ?? {};
    return solver === "exact" && k === undefined && j === undefined && horizon === undefined;
  }

  private showBest(): void {
    if (this.isBest()) this.playground.plans.showAnswer();
    else this.playground.solving.edit({ solver: "exact", k: "", j: "", horizon: "" });
  }

  private entryOf(document: OpenDocument | null): Entry | null {
    if (document === null) return null;
    const { value } = document;
    return entries.find((entry) => this.versions(entry).some((version) => sameProblem(version, value))) ?? null;
  }

  /** The document of an entry, and what its named plans make of it. */
  private versions(entry: Entry): ProblemDocument[] {
    const document = this.documents.value.get(entry.name);
    if (document === undefined) return [];
    const others = (entry.plans ?? []).filter(({ trueGoal }) => trueGoal !== undefined);
    return [document.value, ...others.map(({ trueGoal }) => withTrueGoal(document.value, trueGoal))];
  }
}

const opened = (name: string, text: string): [string, OpenDocument] => [name, { text, value: JSON.parse(text) }];

function withTrueGoal(document: ProblemDocument, trueGoal: string | undefined): ProblemDocument {
  return trueGoal === undefined ? document : { ...(document as DeliveryDocument), true_goal: trueGoal };
}
