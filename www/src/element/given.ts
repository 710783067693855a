// What a page's script gave by `document` or `state`, and whether it is still on its way.
import { parsed } from "./parsed.js";

/** What a page's script asks for. Before there is a view it waits; it goes before attributes and address. */
export interface Wanted {
  document: string | null;
  state: string | null;
  /** Why what was set last could not be used. */
  fault?: string | null;
}

const nothing: Wanted = { document: null, state: null };

export class Given {
  /** The document that was given last: it stands for the element's own until another address is asked for. */
  text: string | null = null;
  /** A step was set while something was on its way: it is one of that. */
  step = false;
  /** The document before, which stands again where the last one can't be opened. */
  private before: string | null;
  private pending: Wanted;

  constructor(
    /** What waited for the view. */
    readonly first: Wanted,
  ) {
    this.pending = first;
    this.before = first.document;
  }

  get document(): unknown {
    return parsed(this.pending.document);
  }

  get state(): unknown {
    return parsed(this.pending.state);
  }

  get isPending(): boolean {
    return this.pending.document !== null || this.pending.state !== null;
  }

  /** `wanted` is being opened, of which `text` is the document; what was on its way comes to nothing. */
  begin(wanted: Wanted, text: string | null): void {
    if (!this.isPending || this.pending === this.first) this.before = this.text;
    this.text = text;
    this.pending = wanted;
    this.step = false;
  }

  /** Attributes are followed: what is on its way is opened by them, unless it came to nothing. What is pending then. */
  join(): Wanted {
    this.pending = this.text === null || !this.isPending ? nothing : { ...this.pending };
    return this.pending;
  }

  /** It is there, or can't be opened. False where something else was asked for meanwhile. */
  end(wanted: Wanted, opened: boolean): boolean {
    if (this.pending !== wanted) return false;
    if (this.isPending && !opened && this.text !== null) this.text = this.before;
    this.pending = nothing;
    return true;
  }

  /** Another address is asked for. */
  drop(): void {
    this.text = null;
  }
}
