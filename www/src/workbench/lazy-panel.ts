// A panel whose code is fetched when it is first looked at.
import { signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit";

/** `Stores`: what the panel shows and changes. */
export type Panel<Stores> = (stores: Stores) => TemplateResult | "";

export class LazyPanel<Stores> {
  private readonly loaded = signal<Panel<Stores> | null>(null);
  private readonly failed = signal(false);
  private asked = false;

  constructor(private readonly load: () => Promise<Panel<Stores>>) {}

  readonly panel: Panel<Stores> = (stores) => {
    const panel = this.loaded.value;
    if (panel !== null) return panel(stores);
    if (this.failed.value) {
      return html`<p>This part of the page could not be loaded.
        <button type="button" @click=${() => this.ask()}>Try again</button></p>`;
    }
    this.ask();
    return html`<p class="waiting">Loading…</p>`;
  };

  private ask(): void {
    if (this.asked) return;
    this.asked = true;
    this.load().then(
      (panel) => {
        this.loaded.value = panel;
      },
      () => {
        this.asked = false;
        this.failed.value = true;
      },
    );
  }
}
