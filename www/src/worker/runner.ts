// The tasks of one part of a playground, one at a time: a newer one makes the older stale.
import type { Ending } from "./client.js";
import { type Job, type News, pagePool, type Urgency } from "./pool.js";
import type { Task } from "./protocol.js";

export class TaskRunner {
  private current: Job | null = null;

  constructor(
    private readonly urgency: Urgency,
    private readonly pool = pagePool,
  ) {}

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
      this.pool.start(job, before);
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

  /** There will be no more tasks. */
  dispose(): void {
    this.drop();
    this.pool.leave(this);
  }
}
