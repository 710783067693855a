// What was there before each edit, and what was undone.
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";

/** More than anybody steps back; documents are small, but not nothing. */
const MOST = 200;

export class History<T> {
  private readonly before = signal<readonly T[]>([]);
  private readonly after = signal<readonly T[]>([]);

  readonly canUndo: ReadonlySignal<boolean> = computed(() => this.before.value.length > 0);
  readonly canRedo: ReadonlySignal<boolean> = computed(() => this.after.value.length > 0);

  /** An edit was made; `previous` is what it was made to. */
  record(previous: T): void {
    this.before.value = [...this.before.value, previous].slice(-MOST);
    this.after.value = [];
  }

  undo(present: T): T | undefined {
    const previous = this.before.value.at(-1);
    if (previous === undefined) return undefined;
    this.before.value = this.before.value.slice(0, -1);
    this.after.value = [...this.after.value, present];
    return previous;
  }

  redo(present: T): T | undefined {
    const next = this.after.value.at(-1);
    if (next === undefined) return undefined;
    this.after.value = this.after.value.slice(0, -1);
    this.before.value = [...this.before.value, present];
    return next;
  }

  /** What there is to go back to when a change comes to nothing: calling it puts everything back. */
  keep(): () => void {
    const [before, after] = [this.before.value, this.after.value];
    return () => {
      this.before.value = before;
      this.after.value = after;
    };
  }

  /** The edit to `present` that was recorded last came to nothing. */
  forget(present: T): void {
    if (this.before.value.at(-1) === present) this.before.value = this.before.value.slice(0, -1);
  }

  clear(): void {
    this.before.value = [];
    this.after.value = [];
  }
}
