// Work that nobody waits for longer than so long. The time counts from when a worker takes the task up: one that is
// still loading, or busy with something else, has not been slow with this; nor has one that waits for the full core, and
// a task that lost its worker to a more urgent one begins with the whole time again.
import type { Ending } from "./client.js";
import type { News } from "./pool.js";
import type { Task } from "./protocol.js";

interface Runs {
  run(task: Task, report: (news: News) => void): Promise<Ending>;
  cancel(): void;
}

interface Patience {
  /** Without end where it is infinite. */
  milliseconds: number;
  report?: (news: News) => void;
  /** The patience is at its end: the task is being cancelled. */
  over?: () => void;
}

/** Runs a task, and cancels it when it has been at work for so long. */
export async function runWithin(runner: Runs, task: Task, { milliseconds, report, over }: Patience): Promise<Ending> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const end = () => {
    over?.();
    runner.cancel();
  };
  const ending = await runner.run(task, (update) => {
    if (update.kind === "fetching" || update.kind === "waiting") clearTimeout(timer);
    if (update.kind === "started" && Number.isFinite(milliseconds)) {
      clearTimeout(timer);
      timer = setTimeout(end, milliseconds);
    }
    report?.(update);
  });
  clearTimeout(timer);
  return ending;
}
