// The tasks of one part of a playground, one at a time: a newer one makes the older stale. While the playground is out of
// the page a task is held without a worker; it begins anew when the playground is back.
import type { Ending } from "./client.js";
import { type Job, type News, pagePool, type Urgency } from "./pool.js";
import type { Task } from "./protocol.js";

export class TaskRunner {
  private current: Job | null = null;
  private asleep = false;

  constructor(
    private readonly urgency: Urgency,
    private readonly pool = pagePool,
  ) {}

  /** Whether a task is under way, or waits. */
  get busy(): boolean {
    return this.current !== null;
  }

  /** Has a worker load the core, for the task that will come. */
  prepare(): void {
    this.pool.prepare(this);
  }

  /** Starts a task; the one before it becomes stale. */
  run(task: Task, report: (news: News) => void = () => undefined): Promise<Ending> {
    return new Promise((resolve) => {
      const job: Job = {
        owner: this,
        urgency: this.urgency,
        task,
        report,
        end: (ending) => {
          if (this.current === job) this.current = null;
          resolve(ending);
        },
      };
      const before = this.current;
      this.current = job;
      if (!this.asleep) this.pool.start(job, before);
      else if (before !== null) this.pool.drop(before);
    });
  }

  /** Asks the task under way to end with the best it has. */
  cancel(): void {
    if (this.current !== null) this.pool.cancel(this.current);
  }

  /** Ends the task under way; its answer is no longer of use. */
  drop(): void {
    if (this.current !== null) this.pool.drop(this.current);
  }

  /** Takes no worker until `wake`: the task under way is held, and so is the next one. */
  sleep(): void {
    if (this.asleep) return;
    this.asleep = true;
    if (this.current !== null) this.pool.hold(this.current);
    this.pool.leave(this);
  }

  /** Begins the task that is held. */
  wake(): void {
    if (!this.asleep) return;
    this.asleep = false;
    const held = this.current;
    if (held === null) return;
    this.pool.start(held, null);
    if (held.cancelled) this.cancel();
  }

  /** There will be no more tasks. */
  dispose(): void {
    this.drop();
    this.pool.leave(this);
  }
}
