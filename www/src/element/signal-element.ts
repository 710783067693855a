// An element that renders again when a signal it read while rendering changes.
import { effect } from "@preact/signals-core";
import { LitElement } from "lit";

export abstract class SignalElement extends LitElement {
  private stopWatching: (() => void) | undefined;

  protected override performUpdate(): void {
    this.stopWatching?.();
    let rendered = false;
    this.stopWatching = effect(() => {
      if (rendered) {
        this.requestUpdate();
      } else {
        rendered = true;
        super.performUpdate();
      }
    });
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.requestUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stopWatching?.();
  }
}
