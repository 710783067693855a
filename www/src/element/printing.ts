// What is on paper and not on the screen: the table of the steps, and of a question all that is opened or written there by
// hand. A browser that prints waits for nothing, so the table's code is fetched in the first pause, and it is drawn at once.
import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import type { StepsTableStores } from "../steps/steps-table.js";

type Table = (stores: StepsTableStores) => TemplateResult | "";

/** A page that is never quiet is printed as well. */
const PAUSE_MS = 3000;

export class Printing {
  /** The page is being printed. */
  readonly under = signal(false);
  private readonly table = signal<Table | null>(null);
  private asked = false;
  /** Told of a preview too, as by the tools of a browser that have no print to begin. */
  private readonly paper = globalThis.matchMedia?.("print");

  /** `draw` draws at once. */
  constructor(private readonly draw: () => void) {}

  connect(): void {
    window.addEventListener("beforeprint", this.begin);
    window.addEventListener("afterprint", this.end);
    this.paper?.addEventListener("change", this.follow);
  }

  disconnect(): void {
    window.removeEventListener("beforeprint", this.begin);
    window.removeEventListener("afterprint", this.end);
    this.paper?.removeEventListener("change", this.follow);
  }

  /** There is something to print: what it takes is fetched in the first pause. */
  prepare(): void {
    if (this.asked) return;
    this.asked = true;
    if (globalThis.requestIdleCallback === undefined) setTimeout(() => void this.load(), PAUSE_MS);
    else requestIdleCallback(() => void this.load(), { timeout: PAUSE_MS });
  }

  content(playground: StepsTableStores): TemplateResult | typeof nothing {
    const table = this.table.value;
    if (!this.under.value || table === null) return nothing;
    return html`<section class="paper" aria-label="The steps on paper"><h2>The steps</h2>${table(playground)}</section>`;
  }

  private readonly begin = () => {
    this.under.value = true;
    this.draw();
    void this.load();
  };

  private readonly end = () => {
    this.under.value = this.paper?.matches === true;
    this.draw();
  };

  private readonly follow = () => (this.paper?.matches ? this.begin() : this.end());

  private async load(): Promise<void> {
    if (this.table.value !== null) return;
    // Without it the rest is printed all the same.
    const loaded = await import("../steps/steps-table.js").catch(() => null);
    if (loaded !== null) this.table.value = loaded.stepsOnPaper;
  }
}
