// The page's side of the worker: gives tasks ids, drops stale replies, and replaces a worker that is lost or does not
// obey a cancel.
import type { Progress, Scene, Trace } from "../core.js";
import { Greeting, type Hello } from "./greeting.js";
import { keptOutcome } from "./kept-outcome.js";
import { NotLoaded } from "./not-loaded.js";
import { chosenPlaces } from "./places.js";
import { whyForbidden } from "./policy.js";
import type { Answer, Message, Reply, Task, Update } from "./protocol.js";
import { type SolverWorker, startWorker } from "./start.js";

/** A worker that has not taken up a task or answered a cancel by then is in one long piece of work: it is ended. */
const PATIENCE_MS = 2000;

/** After an answer and so long a pause, the worker fetches the full core, where `lookAhead` was asked for. */
const PAUSE_MS = 1000;

/** How a task ended, as the page sees it: the worker's answer, or one of the two ends that a worker can't tell. */
export type Ending =
  | Exclude<Answer, { kind: "broken" | "solved" }>
  /** `replaced`: the worker did not obey a cancel, and another took its place. */
  | (Extract<Answer, { kind: "solved" }> & { replaced?: true })
  | { kind: "stale" }
  /** `forbidden`: by the page's content policy; the message says what the policy must allow. `unstarted`: the worker
   * never came to load the core. `advised`: the message says what helps. */
  | ({ kind: "lost"; message: string; unstarted?: true } & Why);

interface Why {
  forbidden?: true;
  advised?: true;
}

interface Current {
  id: number;
  task: Task;
  report: (update: Update) => void;
  end: (ending: Ending) => void;
  last: Progress | null;
  /** The scene and the start, once the worker has told them. */
  opened: { scene: Scene; start: Trace } | null;
  /** When the worker is given up because it has not taken up the task, and because it has not answered a cancel. */
  startBy?: ReturnType<typeof setTimeout>;
  cancelBy?: ReturnType<typeof setTimeout>;
}

export class SolverClient {
  private worker: SolverWorker | null = null;
  /** Whether this worker has loaded the core. One that never did is not replaced before it is needed again. */
  private ready = false;
  private lastId = 0;
  private current: Current | null = null;
  private ahead: ReturnType<typeof setTimeout> | undefined;
  private looksAhead = false;
  private greeting: Greeting | null = null;

  /** Whether there is a worker, ready or loading. */
  get started(): boolean {
    return this.worker !== null;
  }

  /** Has the worker load the core, for the task that will come. */
  prepare(): void {
    this.worker ??= this.startWorker();
  }

  /** From now on the worker fetches the full core in a pause, before anything needs it. */
  lookAhead(): void {
    if (this.looksAhead) return;
    this.looksAhead = true;
    if (this.ready) this.fetchAhead();
  }

  /** Starts a task; any task before it becomes stale. */
  run(task: Task, report: (update: Update) => void = () => undefined): Promise<Ending> {
    this.finish({ kind: "stale" });
    return new Promise((end) => {
      this.lastId += 1;
      const current: Current = { id: this.lastId, task, report, end, last: null, opened: null };
      this.current = current;
      this.send({ ...task, id: current.id });
      // One that is still loading takes as long as the network does.
      if (this.ready) current.startBy = setTimeout(() => this.sendElsewhere(current), PATIENCE_MS);
    });
  }

  /** Asks the task under way to end with the best it has. */
  cancel(): void {
    const current = this.current;
    if (current === null || current.cancelBy !== undefined) return;
    this.send({ kind: "cancel", id: current.id });
    current.cancelBy = setTimeout(() => this.giveUpOn(current), PATIENCE_MS);
  }

  /** Ends the task under way; nobody wants its answer any more. */
  drop(): void {
    if (this.current !== null) this.send({ kind: "cancel", id: this.current.id });
    this.finish({ kind: "stale" });
  }

  /** Ends the worker; the next task starts another. */
  dispose(): void {
    this.finish({ kind: "stale" });
    this.stopWorker();
  }

  private send(message: Message): void {
    clearTimeout(this.ahead);
    this.worker ??= this.startWorker();
    this.worker.postMessage(message);
  }

  private startWorker(): SolverWorker {
    this.ready = false;
    const worker = startWorker();
    const greeting = new Greeting((message) => this.lose(message, { advised: true }));
    this.greeting = greeting;
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      if (greeting.takes(data)) this.take(data);
    };
    worker.onmessageerror = () => this.lose("a message of the solver could not be read");
    worker.onerror = (event) => {
      event.preventDefault();
      this.loseByError(event);
    };
    return worker;
  }

  private stopWorker(): void {
    clearTimeout(this.ahead);
    this.greeting?.end();
    this.worker?.terminate();
    this.worker = null;
  }

  private take(reply: Exclude<Reply, Hello>): void {
    if (reply.kind === "ask") {
      // The worker's own affair: elsewhere.ts answers.
    } else if (reply.kind === "ready") {
      this.ready = true;
    } else if (reply.kind === "broken") {
      this.loseCore(reply);
    } else if (reply.id !== this.current?.id) {
      return;
    } else if (reply.kind === "started") {
      clearTimeout(this.current.startBy);
      this.current.report(reply);
    } else if (reply.kind === "fetching") {
      this.current.report(reply);
    } else if (reply.kind === "progress") {
      this.current.last = reply.progress;
      this.current.report(reply);
    } else if (reply.kind === "opened") {
      this.current.opened = reply;
      this.current.report(reply);
    } else {
      this.finish(reply);
      if (reply.kind === "solved") this.fetchAhead();
    }
  }

  /** Where data is to be saved, nothing is fetched that has not been asked for. */
  private fetchAhead(): void {
    if (!this.looksAhead) return;
    const { connection } = (globalThis.navigator ?? {}) as { connection?: { saveData?: boolean } };
    if (connection?.saveData || this.current !== null) return;
    this.ahead = setTimeout(() => this.send({ kind: "ahead" }), PAUSE_MS);
  }

  private finish(ending: Ending): void {
    const current = this.current;
    this.current = null;
    clearTimeout(current?.startBy);
    clearTimeout(current?.cancelBy);
    current?.end(ending);
  }

  private loseByError({ message, error }: ErrorEvent): void {
    const { worker: placed } = chosenPlaces();
    const forbidden = message ? null : whyForbidden();
    if (forbidden !== null) this.lose(forbidden, { forbidden: true });
    else if (error instanceof NotLoaded) this.lose(message, { advised: true });
    else if (placed === null || this.ready) this.lose(message || "its script did not come");
    else if (message) this.lose(`what worker-url names, “${placed}”, is not its script: ${message}`, { advised: true });
    else this.lose(`no script came from worker-url, “${placed}”`, { advised: true });
  }

  private loseCore({ message, forbidden, advised }: Extract<Reply, { kind: "broken" }>): void {
    const { wasm: placed } = chosenPlaces();
    if (forbidden) this.lose(message, { forbidden });
    else if (advised) this.lose(message, { advised });
    else if (placed === null || this.ready) this.lose(message);
    else this.lose(`what wasm-url names, “${placed}”, is not the core of this version: ${message}`, { advised: true });
  }

  /** The worker is of no more use. Another takes its place, at once if this one had worked. */
  private lose(message: string, why: Why = {}): void {
    const worked = this.ready;
    this.stopWorker();
    if (worked) this.worker = this.startWorker();
    this.finish({
      kind: "lost",
      message,
      ...why,
      ...(worked ? {} : { unstarted: true }),
    });
  }

  /** Ends a worker that is busy with a stale task, and gives the task to another. */
  private sendElsewhere({ task, id }: Current): void {
    this.stopWorker();
    this.send({ ...task, id });
  }

  /** Ends a worker that does not obey, and has another replay the best plan that was reported. */
  private giveUpOn({ task, last, opened, end, startBy }: Current): void {
    clearTimeout(startBy);
    this.stopWorker();
    if (task.kind !== "solve" || opened === null) {
      this.finish({ kind: "refused", message: "Cancelled before there was anything to show." });
      return;
    }
    const { scene, start } = opened;
    const solved = (trace: Trace | null): Ending => ({
      kind: "solved",
      replaced: true,
      scene,
      outcome: keptOutcome(task.options, last, trace),
      trace: trace ?? start,
    });
    if (last === null || last.plan === null) {
      this.finish(solved(null));
      return;
    }
    // The solve goes on as a replay: its end is the solve's.
    this.current = null;
    void this.run({ kind: "trace", document: task.document, plan: last.plan }).then((ending) =>
      end(ending.kind === "traced" ? solved(ending.trace) : ending),
    );
  }
}
