// Copying a short text, and saying whether that was possible.
import { signal } from "@preact/signals-core";
import { copy } from "./clipboard.js";

const SHOWN_MS = 2500;

export class Copier {
  readonly said = signal<"" | "copied" | "refused">("");
  private timer: ReturnType<typeof setTimeout> | undefined;

  async copy(text: string): Promise<void> {
    clearTimeout(this.timer);
    this.said.value = (await copy(text)) ? "copied" : "refused";
    this.timer = setTimeout(() => {
      this.said.value = "";
    }, SHOWN_MS);
  }
}
