// The exercise that is open: its question, the answer that is being made, what was said of it, and its code.
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { ExerciseVerdict, NextAction, PictureOptions, Question, TraceStep } from "../core.js";
import { Copier } from "../view/copier.js";
import type { Ending } from "../worker/client.js";
import type { Board, Fault, Seed } from "../worker/protocol.js";
import { TaskRunner } from "../worker/runner.js";
import { type CheckedAnswer, fitting, type KeptAnswer, type Tries } from "./kept-answer.js";
import { isMissing, lost } from "./lost.js";

export interface Picture {
  board: Board;
  svg: string;
}

type Scheme = NonNullable<PictureOptions["theme"]>;

/** A document with an exercise, asked with a seed. */
interface Posed {
  text: string;
  question: Question;
  seed: Seed;
  /** Whose question it is was left to the student. */
  anyone: boolean;
}

/** Why no question could be asked. */
export interface Refusal {
  message: string;
  /** The same may work the next time. */
  missing: boolean;
}

/** What the core says of an exercise. */
export interface Proof {
  /** Why it cannot be asked. */
  fault: Omit<Fault, "place"> | null;
  /** What makes it trivial. */
  remarks: readonly string[];
  /** What its author should know of its variants. */
  variants: readonly string[];
  /** How many states a student chooses from. */
  states: number;
}

/** What came of a question: nothing more is to be found out where its answer is right or no attempt is left. */
type Standing = "asked" | "right" | "over";

export class Exercise {
  readonly posed = signal<Posed | null>(null);
  /** An exercise is on its way. */
  readonly opening = signal(false);
  /** The boards as SVG: the agent's, and those of the observers where they are not hidden. */
  readonly pictures = signal<readonly Picture[]>([]);
  /** What can be done after the walk that is being given; null while that is not known, or where no walk is asked for. */
  readonly next = signal<readonly NextAction[] | null>(null);
  /** The end of the walk that is being given. */
  readonly last = signal<TraceStep | null>(null);
  /** What is searched for in a long list of choices. */
  readonly filter = signal("");
  /** The choice that has the focus of a grid of choices. */
  readonly cursor = signal(0);
  readonly copier = new Copier();
  /** The positions of the choices made. */
  readonly choices = signal<readonly number[]>([]);
  /** What was said of the last answer that was checked; null once another is being made. */
  readonly verdict = signal<ExerciseVerdict | null>(null);
  /** The code of the last answer that was checked. */
  readonly code = signal<string | null>(null);
  readonly score = signal<number | null>(null);
  readonly attempts = signal(0);
  readonly hints = signal(0);
  /** Something went wrong. */
  readonly error = signal<string | null>(null);
  readonly checking = signal(false);
  /** The page lets no answer be given. */
  readonly disabled = signal(false);
  /** An answer without any choice was to be checked: where it may be one, it is when it is asked for again. */
  readonly unsure = signal(false);
  /** Whether another answer may be tried. */
  readonly canTry: ReadonlySignal<boolean>;
  /** Whether an answer must have a choice: some state is always possible, and one goal or cell is asked for. */
  readonly needsChoice: ReadonlySignal<boolean>;
  /** The true goal, where that was the question and the answer that was checked last is right. */
  readonly foundGoal: ReadonlySignal<string | null>;
  /** The name whose question is shown; empty: the question without a name; null: none was given. */
  readonly name = signal<string | null>(null);
  /** Whether the question that was asked for last could not be: nothing of its problem may be shown in its place. */
  readonly refused = signal(false);
  /** Whether a name is to be given, since the question differs from student to student and the page has not said whose it is. */
  readonly asksName: ReadonlySignal<boolean>;
  /** Whether the page leaves it to the student whose question is shown. */
  anyone = false;
  /** What the page asks for by attributes. */
  seed: Seed = 0;
  block: string | null = null;
  private scheme: Scheme = "light";
  /** Questions and verdicts. */
  private readonly runner = new TaskRunner("now");
  /** The answer that was checked last. */
  private readonly checked = signal<CheckedAnswer | null>(null);
  /** What was tried of the questions that were shown before this one, by their seeds. */
  private tries = new Map<number, Tries>();
  /** Pictures of walks, which come and go beside them. */
  private readonly drawer = new TaskRunner("now");

  constructor() {
    this.asksName = computed(() => (this.posed.value?.question.varies ?? false) && this.posed.value?.anyone === true);
    this.needsChoice = computed(() => {
      const { arity, choice } = this.posed.value?.question.form ?? {};
      return arity === "one" || choice === "state";
    });
    this.foundGoal = computed(() => {
      const [question, choice] = [this.posed.value?.question, this.checked.value?.choices[0]];
      if (question?.kind !== "guess" || choice === undefined || this.score.value !== 1) return null;
      return String(question.form.choices[choice]);
    });
    this.canTry = computed(() => {
      const question = this.posed.value?.question;
      if (this.asksName.value && this.name.value === null) return false;
      if (question === undefined || this.checking.value || this.opening.value) return false;
      const left = question.attempts === undefined || this.attempts.value < question.attempts;
      return left && !this.disabled.value && this.verdict.value === null;
    });
  }

  /** The text of a document with the exercise that belongs to it; null where it is a problem without one. */
  textOf(text: string): string | null {
    let value: unknown;
    try {
      value = JSON.parse(text);
    } catch {
      return null;
    }
    if (typeof value !== "object" || value === null) return null;
    if ("exercise" in value) return text;
    return this.block === null ? null : withBlock(value, this.block);
  }

  /** Asks the question of a document. Null where that was possible, else why not. */
  open(text: string): Promise<Refusal | null> {
    return this.ask(text, null, new Map());
  }

  /** `tries`: what was tried of questions of the document before. */
  private async ask(text: string, name: string | null, tries: Map<number, Tries>): Promise<Refusal | null> {
    this.opening.value = true;
    const { anyone } = this;
    const seed = name === null || name === "" ? this.seed : { name };
    const ending = await this.runner.run({ kind: "exercise", document: text, seed });
    if (ending.kind === "stale") return null;
    this.opening.value = false;
    this.refused.value = ending.kind !== "asked";
    if (ending.kind !== "asked") return { message: messageOf(ending), missing: isMissing(ending) };
    const { question } = ending;
    batch(() => {
      if (tries === this.tries) this.remember();
      this.tries = tries;
      this.posed.value = { text, question, seed, anyone };
      this.name.value = name;
      this.pictures.value = [];
      this.next.value = null;
      this.last.value = null;
      this.cursor.value = 0;
      this.filter.value = "";
      this.forget();
    });
    void this.draw();
    const before = tries.get(question.seed);
    if (before !== undefined) await this.goOn(before);
    return null;
  }

  /**
   * Shows the question that belongs to a name in place of the one that is open. What was tried of a question stays tried:
   * it goes on there when its name is asked for again.
   */
  async call(name: string): Promise<void> {
    const posed = this.posed.value;
    const wanted = name.trim();
    if (posed === null || !this.asksName.value || (wanted === this.name.value && !this.opening.value)) return;
    const refused = await this.ask(posed.text, wanted, this.tries);
    if (refused !== null && posed === this.posed.value) this.error.value = refused.message;
  }

  /** What is wrong with a document's exercise, what makes it trivial, and what is wrong with its variants; null where another was looked at meanwhile. */
  async prove(text: string): Promise<Proof | null> {
    const ending = await this.runner.run({ kind: "prove", document: text });
    if (ending.kind === "stale") return null;
    if (ending.kind === "proved") return ending;
    return { fault: { message: messageOf(ending) }, remarks: [], variants: [], states: 0 };
  }

  /** Gives up a question that is on its way. */
  stopOpening(): void {
    if (!this.opening.value) return;
    this.runner.drop();
    this.opening.value = false;
  }

  close(): void {
    this.runner.drop();
    this.drawer.drop();
    this.opening.value = false;
    this.refused.value = false;
    this.posed.value = null;
    this.forget();
  }

  /** What came of a question to which an answer was kept, as the core says. */
  async standing(text: string, { name, attempts, checked }: KeptAnswer): Promise<Standing> {
    const seed = name === undefined || name === "" ? this.seed : { name };
    const asked = await this.runner.run({ kind: "exercise", document: text, seed });
    if (asked.kind !== "asked") return "asked";
    const { attempts: most, form } = asked.question;
    const unless = most !== undefined && attempts >= most ? "over" : "asked";
    if (checked === undefined) return unless;
    const answer = { ...checked, choices: fitting(checked.choices, form) };
    const ending = await this.runner.run({ kind: "judge", document: text, seed, ...answer });
    return ending.kind === "judged" && ending.verdict.right ? "right" : unless;
  }

  /** Goes on with an answer that was kept. */
  async resume(kept: KeptAnswer): Promise<void> {
    if (kept.name !== undefined) await this.call(kept.name);
    for (const { seed, ...tries } of kept.others ?? []) this.tries.set(seed, tries);
    await this.goOn(kept);
  }

  /** What an answer is worth that was checked before, the core says again. */
  private async goOn({ choices, attempts, hints, checked }: Tries): Promise<void> {
    const posed = this.posed.value;
    if (posed === null) return;
    const { text, seed, question } = posed;
    const known = checked === undefined ? null : { ...checked, choices: fitting(checked.choices, question.form) };
    batch(() => {
      this.change(fitting(choices, question.form));
      this.attempts.value = attempts;
      this.hints.value = Math.min(hints, question.hints.length);
      this.checked.value = known;
      this.checking.value = known !== null;
    });
    if (known === null) return;
    const ending = await this.runner.run({ kind: "judge", document: text, seed, ...known });
    if (ending.kind === "stale" || posed !== this.posed.value) return;
    batch(() => {
      this.checking.value = false;
      if (ending.kind === "judged") this.tell(ending.verdict, known.choices);
      else this.checked.value = null;
      if (ending.kind === "lost") this.error.value = messageOf(ending);
    });
  }

  /** What was said of an answer. Another one may be on its way. */
  private tell(verdict: ExerciseVerdict, choices: readonly number[]): void {
    this.code.value = verdict.code;
    this.score.value = verdict.score;
    if (String(choices) === String(this.choices.value)) this.verdict.value = verdict;
  }

  /** Makes a choice: the one, one more or less of a set, or the next of a sequence. */
  choose(choice: number): void {
    const arity = this.posed.value?.question.form.arity;
    const before = this.choices.value;
    if (arity === "one") this.change([choice]);
    else if (arity === "sequence") this.change([...before, choice]);
    else this.change(before.includes(choice) ? before.filter((other) => other !== choice) : [...before, choice]);
  }

  /** Takes the last step of a walk back. */
  back(): void {
    this.change(this.choices.value.slice(0, -1));
  }

  clear(): void {
    this.change([]);
  }

  hint(): void {
    const most = this.posed.value?.question.hints.length ?? 0;
    this.hints.value = Math.min(most, this.hints.value + 1);
  }

  /** Has the answer checked: it counts as an attempt. */
  async check(): Promise<void> {
    const posed = this.posed.value;
    if (posed === null || !this.canTry.value) return;
    const isEmpty = this.choices.value.length === 0;
    if (isEmpty && (this.needsChoice.value || !this.unsure.value)) {
      this.unsure.value = true;
      return;
    }
    this.checking.value = true;
    const answer = { choices: [...this.choices.value], hints: this.hints.value, attempts: this.attempts.value + 1 };
    const { text, seed } = posed;
    const ending = await this.runner.run({ kind: "judge", document: text, seed, ...answer });
    this.checking.value = false;
    if (ending.kind === "stale" || posed !== this.posed.value) return;
    if (ending.kind !== "judged") {
      this.error.value = messageOf(ending);
      return;
    }
    batch(() => {
      this.error.value = null;
      this.attempts.value = answer.attempts;
      this.unsure.value = false;
      this.checked.value = answer;
      this.tell(ending.verdict, answer.choices);
    });
  }

  /** The answer as a link keeps it. */
  get kept(): KeptAnswer {
    const shown = this.posed.value?.question.seed;
    const others = [...this.tries].filter(([seed]) => seed !== shown).map(([seed, tries]) => ({ seed, ...tries }));
    return {
      ...this.tried,
      ...(this.name.value === null ? {} : { name: this.name.value }),
      ...(others.length === 0 ? {} : { others }),
    };
  }

  /** What was tried of the question that is shown. */
  private get tried(): Tries {
    const checked = this.checked.value;
    return {
      choices: [...this.choices.value],
      attempts: this.attempts.value,
      hints: this.hints.value,
      ...(checked === null ? {} : { checked }),
    };
  }

  private remember(): void {
    const { tried } = this;
    const seed = this.posed.value?.question.seed;
    const begun = tried.attempts > 0 || tried.hints > 0 || tried.choices.length > 0;
    if (seed !== undefined && begun) this.tries.set(seed, tried);
  }

  sleep(): void {
    this.runner.sleep();
    this.drawer.sleep();
  }

  wake(): void {
    this.runner.wake();
    this.drawer.wake();
  }

  private change(choices: readonly number[]): void {
    batch(() => {
      this.choices.value = choices;
      this.verdict.value = null;
      this.error.value = null;
      this.unsure.value = false;
    });
    if (this.posed.value?.question.form.choice === "action") void this.draw();
  }

  private forget(): void {
    batch(() => {
      this.choices.value = [];
      this.verdict.value = null;
      this.checked.value = null;
      this.code.value = null;
      this.score.value = null;
      this.attempts.value = 0;
      this.hints.value = 0;
      this.error.value = null;
      this.checking.value = false;
      this.unsure.value = false;
    });
  }

  /** The colours of pictures. */
  colour(scheme: Scheme): void {
    if (scheme === this.scheme) return;
    this.scheme = scheme;
    void this.draw();
  }

  /** The picture of the walk that is told, or of the one that is being given. */
  private async draw(): Promise<void> {
    const posed = this.posed.value;
    if (posed === null) return;
    const { document, form, hide, kind, plan: told } = posed.question;
    const given = form.choice === "action" ? this.choices.value.map((choice) => String(form.choices[choice])) : [];
    const boards: Board[] = hide.includes("beliefs") ? ["actor"] : ["actor", "adversarial", "cooperative"];
    const options: PictureOptions = {
      // Who guesses the goal must not see which it is.
      true_goal: kind !== "guess",
      ended: told !== undefined,
      theme: this.scheme,
    };
    const plan = told ?? given;
    const ending = await this.drawer.run({ kind: "sketch", document: JSON.stringify(document), plan, boards, options });
    if (ending.kind === "stale" || posed !== this.posed.value) return;
    if (ending.kind !== "sketched") {
      this.error.value = messageOf(ending);
      return;
    }
    batch(() => {
      this.pictures.value = ending.pictures.map((svg, index) => ({ board: boards[index] ?? "actor", svg }));
      this.next.value = ending.next;
      this.last.value = ending.last;
    });
  }
}

function withBlock(document: object, block: string): string {
  try {
    return JSON.stringify({ ...document, exercise: JSON.parse(block) });
  } catch {
    // The core says what is wrong with it.
    return JSON.stringify({ ...document, exercise: block });
  }
}

function messageOf(ending: Ending): string {
  if (ending.kind === "lost") return lost(ending);
  return ending.kind === "refused" ? ending.message : "The exercise could not be opened.";
}
