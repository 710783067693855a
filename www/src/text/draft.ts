// What stands in the document's text field: the document that is open, or what somebody is making of it.
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Answer } from "../state/answer.js";
import { Coalesce } from "../state/coalesce.js";
import type { Edits } from "../state/edits.js";
import { type Begun, KeptDraft } from "../state/kept-draft.js";
import type { OpenProblem } from "../state/open-problem.js";
import type { Workbench } from "../state/workbench.js";
import type { Fault } from "../worker/protocol.js";
import { TaskRunner } from "../worker/runner.js";

interface DraftStores {
  problem: OpenProblem;
  answer: Answer;
  edits: Edits;
  workbench: Pick<Workbench, "id" | "open">;
}

export class Draft {
  /** The text as it was changed, and the document that it was changed from or is kept beside. */
  private readonly typed = signal<Begun | null>(null);
  /** What the core said of a text last. */
  readonly checked = signal<{ text: string; fault: Fault | null } | null>(null);

  /** Follows the open document, but for a text that was begun and not used: that one stays. */
  readonly text: ReadonlySignal<string> = computed(() => this.typed.value?.text ?? this.open.value);
  readonly changed: ReadonlySignal<boolean> = computed(() => this.text.value !== this.open.value);
  /** The problem changed under a text that was begun and not used. */
  readonly overtaken: ReadonlySignal<boolean> = computed(
    () => this.changed.value && this.typed.value !== null && this.typed.value.from !== this.open.value,
  );

  /** The text of the document that is open. */
  readonly open: ReadonlySignal<string> = computed(() => this.playground.problem.document.value?.text ?? "");
  /** Why the page did not take the text: who goes on typing knows, and sees what is wrong at its place. */
  private refused: string | null | undefined;
  private readonly checker = new TaskRunner("soon");
  private readonly checks = new Coalesce<string>((text) => this.perform(text));

  /** What is wrong with the text is to be shown at its place as soon as that is known. */
  readonly toFault = signal(false);
  private readonly kept: KeptDraft;
  /** Whether what was kept was looked for: there is a document that it may belong to. */
  private begun = false;
  private written: Begun | null = null;

  constructor(private readonly playground: DraftStores) {
    this.kept = new KeptDraft(playground.workbench.id);
    effect(() => {
      const document = this.playground.problem.document.value;
      if (document === null) return;
      if (!this.begun) {
        this.begun = true;
        this.typed.value ??= this.kept.read(document.text);
      }
      this.kept.listen();
      const begun = this.changed.value ? this.typed.value : null;
      // What was begun from another document stays kept until there is something newer.
      if (begun !== this.written) this.kept.write(begun);
      this.written = begun;
    });
  }

  type(text: string): void {
    if (this.playground.answer.error.peek() === this.refused) this.playground.answer.error.value = null;
    if (text === this.open.value) {
      this.forget();
      return;
    }
    // The document that it is begun from stays the one that it is compared with.
    const begun = this.changed.value ? this.typed.value : null;
    this.typed.value = { text, from: begun?.from ?? this.open.value };
  }

  /** Has the core say whether a text is right; of many in short time only the last. */
  check(text: string): void {
    if (this.checked.value?.text !== text) this.checks.ask(text);
  }

  /** The text stays, and belongs to the document that is open now. */
  keep(): void {
    this.typed.value = { text: this.text.value, from: this.open.value };
  }

  /** The text of the document that is open comes back. */
  forget(): void {
    this.typed.value = null;
  }

  /** What the core says of a text; null where that is nothing, or it could not be asked. */
  async faultOf(text: string): Promise<Fault | null> {
    if (this.checked.value?.text !== text) await this.perform(text);
    return this.checked.value?.text === text ? this.checked.value.fault : null;
  }

  /** Shows a text that the core refused at what is wrong with it; not where another text would be lost by that. */
  present(text: string): void {
    if (this.changed.value) return;
    this.type(text);
    this.toFault.value = true;
    this.playground.workbench.open("document");
  }

  /** Makes the text the open document. `words`: how what is wrong with it is said. */
  async use(words: (fault: Fault) => string): Promise<void> {
    const text = this.text.value;
    this.refused = undefined;
    if (!(await this.playground.edits.rewrite(text))) {
      const { error } = this.playground.answer;
      const fault = await this.faultOf(text);
      if (fault !== null && error.peek() === fault.message) error.value = words(fault);
      this.refused = error.peek();
      return;
    }
    // Somebody may have gone on typing.
    if (this.text.value === text) this.forget();
    else this.keep();
  }

  sleep(): void {
    this.kept.release();
    this.checker.sleep();
  }

  wake(): void {
    if (this.begun) this.kept.listen();
    this.checker.wake();
  }

  private async perform(text: string): Promise<void> {
    const ending = await this.checker.run({ kind: "check", document: text });
    if (ending.kind === "checked") this.checked.value = { text, fault: ending.fault };
  }
}
