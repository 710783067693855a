// The workers of a page: at most three, shared by all its playgrounds, each started when there is work for it.
//
// The first is kept for what the page is asked for now, so that an edit is answered at once whatever else is worked out.
// A task that finds no worker takes that of a less urgent one, which begins again as soon as a worker is free.
import { type Ending, SolverClient } from "./client.js";
import type { Task, Update } from "./protocol.js";

export const MOST_WORKERS = 3;

/** What is edited or asked now; what is worked out beside it; what takes long and was asked for as such. */
export type Urgency = "now" | "soon" | "later";
const urgencies: readonly Urgency[] = ["now", "soon", "later"];

/** What a task tells on its way. `waiting`: there is no worker for it, or no longer; once there is, it begins anew. */
export type News = Update | { kind: "waiting" };

export interface Job {
  readonly owner: object;
  readonly urgency: Urgency;
  readonly task: Task;
  readonly report: (news: News) => void;
  readonly end: (ending: Ending) => void;
  cancelled?: true;
}

interface Place {
  readonly client: SolverClient;
  job: Job | null;
  /** The job's run by the client: a job may be taken away and given back before the end of an earlier one is heard. */
  run: Promise<Ending> | null;
  /** Whose task was here last: its problem is still open there. */
  last: object | null;
}

export class WorkerPool {
  private readonly places: readonly Place[] = [...Array(MOST_WORKERS).keys()].map(() => ({
    client: new SolverClient(),
    job: null,
    run: null,
    last: null,
  }));
  private waiting: readonly Job[] = [];
  /** Those that may have tasks; without any, no worker is kept. */
  private readonly owners = new Set<object>();

  /** Has a worker load the core for the tasks of `owner` that will come. */
  prepare(owner: object): void {
    this.owners.add(owner);
    this.places[0]?.client.prepare();
  }

  /** From now on workers fetch the full core in a pause: somebody is at work, and edits are answered faster by it. */
  lookAhead(): void {
    for (const { client } of this.places) client.lookAhead();
  }

  /** Starts a job as soon as there is a worker; `before`, an older job of the same owner, becomes stale. */
  start(job: Job, before: Job | null): void {
    this.owners.add(job.owner);
    const own = before === null ? undefined : this.placeOf(before);
    if (before !== null) this.forget(before);
    const place = own ?? this.idlePlace(job) ?? this.takenFromOther(job);
    if (place !== undefined) {
      this.assign(place, job);
      return;
    }
    this.waiting = [...this.waiting, job];
    job.report({ kind: "waiting" });
  }

  /** Asks a job to end with the best it has. */
  cancel(job: Job): void {
    const place = this.placeOf(job);
    if (place !== undefined) {
      job.cancelled = true;
      place.client.cancel();
    } else if (this.waiting.includes(job)) {
      this.waiting = this.waiting.filter((other) => other !== job);
      job.end({ kind: "refused", message: "Cancelled before there was anything to show." });
    }
  }

  /** Ends a job whose answer is no longer of use. */
  drop(job: Job): void {
    const place = this.placeOf(job);
    this.forget(job);
    place?.client.drop();
    // The owner may have another job for the same worker in this turn.
    queueMicrotask(() => this.next());
  }

  /** Takes a job from its worker, or from those that wait, without an end: its owner may start it again. */
  hold(job: Job): void {
    const place = this.placeOf(job);
    if (place !== undefined) place.job = null;
    this.waiting = this.waiting.filter((other) => other !== job);
    job.report({ kind: "waiting" });
    place?.client.drop();
    queueMicrotask(() => this.next());
  }

  /** `owner` has no more tasks; the workers end with the last of the owners. */
  leave(owner: object): void {
    this.owners.delete(owner);
    if (this.owners.size === 0) for (const { client } of this.places) client.dispose();
  }

  private placeOf(job: Job): Place | undefined {
    return this.places.find((place) => place.job === job);
  }

  private placesFor({ urgency }: Job): readonly Place[] {
    return urgency === "now" ? this.places : this.places.slice(1);
  }

  private idlePlace(job: Job): Place | undefined {
    const idle = this.placesFor(job).filter((place) => place.job === null);
    return (
      idle.find(({ last, client }) => last === job.owner && client.started) ??
      idle.find(({ client }) => client.started) ??
      idle[0]
    );
  }

  /** The place of the least urgent job that is less urgent than this one. */
  private takenFromOther(job: Job): Place | undefined {
    const rank = (place: Place) =>
      place.job === null || place.job.cancelled ? -1 : urgencies.indexOf(place.job.urgency);
    const [place] = [...this.placesFor(job)].sort((one, other) => rank(other) - rank(one));
    const other = place?.job ?? null;
    if (place === undefined || other === null || rank(place) <= urgencies.indexOf(job.urgency)) return undefined;
    this.waiting = [other, ...this.waiting];
    other.report({ kind: "waiting" });
    return place;
  }

  private assign(place: Place, job: Job): void {
    place.job = job;
    place.last = job.owner;
    const run = place.client.run(job.task, job.report);
    place.run = run;
    void run.then((ending) => {
      // Another job has the place by now; this one was told.
      if (place.job !== job || place.run !== run) return;
      place.job = null;
      job.end(ending);
      this.next();
    });
  }

  private forget(job: Job): void {
    const place = this.placeOf(job);
    if (place !== undefined) place.job = null;
    this.waiting = this.waiting.filter((other) => other !== job);
    job.end({ kind: "stale" });
  }

  /** Gives free places to jobs that wait, the most urgent first. */
  private next(): void {
    for (const urgency of urgencies) {
      for (const job of this.waiting.filter((one) => one.urgency === urgency)) {
        const place = this.idlePlace(job);
        if (place === undefined) break;
        this.waiting = this.waiting.filter((other) => other !== job);
        this.assign(place, job);
      }
    }
  }
}

/** The one of this page. */
export const pagePool = new WorkerPool();
