// What a page's script gave by `document` or `state`, and whether it is still on its way.
import { parsed } from "./parsed.js";

/** What a page's script asks for. Before there is a view it waits; it goes before attributes and address. */
export interface Wanted {
  document: string | null;
  state: string | null;
  /** Why what was set last could not be used. */
  fault?: string | null;
}

/** What attributes are of: a document, and the state that it came with. */
interface Source {
  text: string | null;
  state: string | null;
}

const nothing: Wanted = { document: null, state: null };
const none: Source = { text: null, state: null };

export class Given {
  /** The attributes that were set since: they are of what was given. */
  readonly changed = new Set<string>();
  /** What was given last: it stands for the element's own document until another address is asked for. */
  private source: Source = none;
  /** What was given before, which stands again where the last one can't be opened. */
  private before: Source;
  private pending: Wanted;

  constructor(
    /** What waited for the view. */
    readonly first: Wanted,
  ) {
    this.pending = first;
    this.before = { text: first.document, state: null };
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

  /** The document that was given last. */
  get text(): string | null {
    return this.source.text;
  }

  /** The state that the document came with: it has options and a plan of its own. */
  get stateText(): string | null {
    return this.source.state;
  }

  /** The document that waited for the view is what attributes are of. */
  takeFirst(): void {
    this.source = { text: this.first.document, state: null };
  }

  /** `wanted` is being opened, of which `text` is the document; what was on its way comes to nothing. */
  begin(wanted: Wanted, text: string | null): void {
    if (!this.isPending || this.pending === this.first) this.before = this.source;
    this.source = { text, state: wanted.state };
    this.pending = wanted;
    this.changed.clear();
  }

  /** Attributes are followed: what is on its way is opened by them, unless it came to nothing. What is pending then. */
  join(): Wanted {
    this.pending = this.text === null || !this.isPending ? nothing : { ...this.pending };
    return this.pending;
  }

  /** It is there, or can't be opened. False where something else was asked for meanwhile. */
  end(wanted: Wanted, opened: boolean): boolean {
    if (this.pending !== wanted) return false;
    if (this.isPending && !opened && this.text !== null) this.source = this.before;
    this.pending = nothing;
    return true;
  }

  /** Another address is asked for. */
  drop(): void {
    this.source = none;
  }
}
