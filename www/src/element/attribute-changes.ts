// Attributes that a page changes in one turn, as one change.
import { leaveOther } from "./settings.js";

export class AttributeChanges {
  private readonly names = new Set<string>();
  /** An address is taken away since another one was set. */
  private leaving = false;

  constructor(
    private readonly host: Element,
    /** Hears of all that changed, once the turn is over. */
    private readonly follow: (names: ReadonlySet<string>) => void,
  ) {}

  /** False where it is not the page that changed it. */
  add(name: string): boolean {
    // A page that changes several means all of them at once.
    if (this.names.size === 0) queueMicrotask(() => this.end());
    this.names.add(name);
    return !this.leaving;
  }

  private end(): void {
    this.leaving = true;
    leaveOther(this.host, this.names);
    this.leaving = false;
    const names = new Set(this.names);
    this.names.clear();
    this.follow(names);
  }
}
