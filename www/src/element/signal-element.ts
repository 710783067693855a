// An element that renders again when a signal it read while rendering changes.
import { effect } from "@preact/signals-core";
import { LitElement } from "lit";
import { nextTurn } from "../worker/turn.js";

export abstract class SignalElement extends LitElement {
  private stopWatching: (() => void) | undefined;

  /** The first picture is a turn of its own, not the end of the one that reads the page's code. */
  protected override async scheduleUpdate(): Promise<void> {
    if (!this.hasUpdated) await nextTurn();
    super.scheduleUpdate();
  }

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
