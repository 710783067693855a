// What the solver answered, what is the best possible, and what it is doing now.
import { batch, signal } from "@preact/signals-core";
import type { Outcome, Progress, SolveOptions, Trace } from "../core.js";
import type { Ending } from "../worker/client.js";
import type { Answered } from "../worker/protocol.js";
import type { Form } from "./form.js";
import { lost } from "./lost.js";
import { Stopwatch } from "./stopwatch.js";

export type Status = "idle" | "solving" | "error" | Outcome["status"];

/** What a solve was asked and answered. */
export interface Result {
  options: SolveOptions;
  outcome: Answered;
}

export class Answer {
  readonly result = signal<Result | null>(null);
  /** The exact answer for the document that is open, whatever was solved since. */
  readonly optimum = signal<Result | null>(null);
  readonly status = signal<Status>("idle");
  /** Solving takes so long that it should be seen. */
  readonly slow = signal(false);
  readonly error = signal<string | null>(null);
  /** Does again what came to nothing for want of a connection or of a solver; null where that would be of no use. */
  readonly again = signal<(() => void) | null>(null);
  readonly progress = signal<Progress | null>(null);
  /** How long the solver has been at work. */
  readonly stopwatch = new Stopwatch();
  /** The solver that was run by hand last, on this problem or on what it was edited from. */
  readonly ran = signal<Form["solver"] | null>(null);
  /** The steps of the result, to come back to. */
  trace: Trace | null = null;

  begin(): void {
    if (this.status.value !== "solving") this.stopwatch.start();
    batch(() => {
      this.error.value = null;
      this.again.value = null;
      this.status.value = "solving";
    });
  }

  /** `more`: another solve waits behind this one. */
  take(result: Result, trace: Trace, more: boolean): void {
    this.stopwatch.stop();
    batch(() => {
      this.result.value = result;
      if (result.options.solver === "exact") this.optimum.value = result;
      this.status.value = more ? "solving" : result.outcome.status;
      this.progress.value = null;
      this.slow.value = false;
      this.trace = trace;
    });
  }

  /** Another document is shown, of which nothing is known but its start. */
  forget(start: Trace): void {
    this.result.value = null;
    this.trace = start;
  }

  /** A document is shown that is not to be solved. */
  rest(start: Trace): void {
    this.stopwatch.stop();
    batch(() => {
      this.forget(start);
      this.ran.value = null;
      this.status.value = "idle";
      this.progress.value = null;
      this.slow.value = false;
    });
  }

  /** Says why there is no answer; what was answered before stays. `again` asks for the same once more. */
  fail(ending: Ending, again: (() => void) | null = null): void {
    // What came after a stale task sets the state itself.
    if (ending.kind !== "refused" && ending.kind !== "lost") return;
    this.stopwatch.stop();
    batch(() => {
      this.progress.value = null;
      this.slow.value = false;
      this.status.value = "error";
      this.again.value = again;
      this.error.value = ending.kind === "refused" ? ending.message : lost(ending);
    });
  }

  /** Says why something was not done; what is open and under way goes on. */
  remark(message: string): void {
    this.again.value = null;
    this.error.value = message;
  }

  /** The person has read what went wrong: what is shown is the last answer again. */
  dismiss(): void {
    this.error.value = null;
    if (this.status.value !== "error") return;
    this.status.value = this.result.value?.outcome.status ?? "idle";
  }

  sleep(): void {
    this.stopwatch.halt();
  }

  wake(): void {
    this.stopwatch.goOn();
  }
}
