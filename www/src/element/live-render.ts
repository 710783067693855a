// Renders again when a signal that was read while rendering changes: many changes of one turn are one picture.
import { effect } from "@preact/signals-core";
import { render, type TemplateResult } from "lit";

export class LiveRender {
  private stopWatching: (() => void) | undefined;
  private connected = false;
  private asked = false;

  constructor(
    private readonly root: HTMLElement,
    private readonly content: () => TemplateResult,
    /** After each picture; what it reads is followed as well. */
    private readonly drawn: () => void,
  ) {}

  connect(): void {
    this.connected = true;
    this.request();
  }

  disconnect(): void {
    this.connected = false;
    this.stopWatching?.();
  }

  request(): void {
    if (this.asked) return;
    this.asked = true;
    queueMicrotask(() => this.now());
  }

  /** Renders what was asked for without waiting for the turn's end. */
  now(): void {
    if (!this.asked) return;
    this.asked = false;
    if (this.connected) this.perform();
  }

  private perform(): void {
    this.stopWatching?.();
    let rendered = false;
    this.stopWatching = effect(() => {
      if (rendered) {
        this.request();
      } else {
        rendered = true;
        render(this.content(), this.root);
        this.drawn();
      }
    });
  }
}
