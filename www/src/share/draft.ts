// What stands in the document's text field: the document that is open, or what somebody is making of it.
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Playground } from "../state/playground.js";

export class Draft {
  /** The text as it was changed, and the document that it was changed from. */
  private readonly typed = signal<{ text: string; from: string } | null>(null);
  /** What was typed and refused, and why. */
  private readonly refused = signal<{ text: string; message: string } | null>(null);

  /** Follows the open document: a text that was begun for another one is put aside. */
  readonly text: ReadonlySignal<string> = computed(() => this.current.value?.text ?? this.open.value);
  readonly changed: ReadonlySignal<boolean> = computed(() => this.text.value !== this.open.value);
  /** A text that was begun and not used, when the document changed under it. */
  readonly aside: ReadonlySignal<string | null> = computed(() => {
    const typed = this.typed.value;
    return typed === null || typed.from === this.open.value || typed.text === this.open.value ? null : typed.text;
  });
  readonly error: ReadonlySignal<string | null> = computed(() => {
    const refused = this.refused.value;
    return refused !== null && refused.text === this.text.value ? refused.message : null;
  });

  private readonly open: ReadonlySignal<string> = computed(() => this.playground.document.value?.text ?? "");
  private readonly current = computed(() => (this.typed.value?.from === this.open.value ? this.typed.value : null));

  constructor(private readonly playground: Playground) {}

  type(text: string): void {
    this.typed.value = { text, from: this.open.value };
  }

  /** Puts the text that was put aside back into the field. */
  bringBack(): void {
    const text = this.aside.value;
    if (text !== null) this.type(text);
  }

  forget(): void {
    this.typed.value = null;
    this.refused.value = null;
  }

  /** Makes the text the open document. */
  async use(): Promise<void> {
    const text = this.text.value;
    this.refused.value = null;
    if (await this.playground.open(text)) this.forget();
    else this.refused.value = { text, message: this.playground.error.value ?? "" };
  }
}
