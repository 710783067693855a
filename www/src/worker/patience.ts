// Work that nobody waits for longer than so long. The time counts from when a worker takes the task up: one that is
// still loading, or busy with something else, has not been slow with this; nor has one that waits for the full core.
import type { Ending, SolverClient } from "./client.js";
import type { Task, Update } from "./protocol.js";

interface Patience {
  /** Without end where it is infinite. */
  milliseconds: number;
  report?: (update: Update) => void;
  /** The patience is at its end: the task is being cancelled. */
  over?: () => void;
}

/** Runs a task, and cancels it when it has been at work for so long. */
export async function runWithin(
  client: SolverClient,
  task: Task,
  { milliseconds, report, over }: Patience,
): Promise<Ending> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const end = () => {
    over?.();
    client.cancel();
  };
  const ending = await client.run(task, (update) => {
    if (update.kind === "fetching") clearTimeout(timer);
    if (update.kind === "started" && Number.isFinite(milliseconds)) {
      clearTimeout(timer);
      timer = setTimeout(end, milliseconds);
    }
    report?.(update);
  });
  clearTimeout(timer);
  return ending;
}
