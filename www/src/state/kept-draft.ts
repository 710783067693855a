// A text that was begun and not used, kept in the browser's tab: a reload does not lose it.

/** The text, and the document that it was begun from. */
export interface Begun {
  text: string;
  from: string;
}

export class KeptDraft {
  /** Whether what was begun last is nowhere but in the page. */
  private unkept = false;

  /** `name`: which playground of the page it is of. */
  constructor(private readonly name: string) {}

  /** The page may be left only knowingly while a text is nowhere else. */
  listen(): void {
    window.addEventListener("beforeunload", this.leaving);
  }

  release(): void {
    window.removeEventListener("beforeunload", this.leaving);
  }

  /** What was begun before the page was loaded; null where that is nothing, or of another document than `open`. */
  read(open: string): Begun | null {
    try {
      const { text, from } = JSON.parse(sessionStorage.getItem(this.key) ?? "null") ?? {};
      if (typeof text !== "string" || typeof from !== "string" || text === open) return null;
      return from === open || reloaded() ? { text, from } : null;
    } catch {
      return null;
    }
  }

  write(begun: Begun | null): void {
    this.unkept = false;
    try {
      if (begun === null) sessionStorage.removeItem(this.key);
      else sessionStorage.setItem(this.key, JSON.stringify(begun));
    } catch {
      // No storage for this page, or not so much of it.
      this.unkept = begun !== null;
    }
  }

  private get key(): string {
    return `${this.name} draft ${location.pathname}`;
  }

  private readonly leaving = (event: BeforeUnloadEvent) => {
    if (this.unkept) event.preventDefault();
  };
}

function reloaded(): boolean {
  const [navigation] = performance.getEntriesByType("navigation");
  return navigation instanceof PerformanceNavigationTiming && navigation.type === "reload";
}
