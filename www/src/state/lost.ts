// What is said of a worker that was lost.
import type { Ending } from "../worker/client.js";

/** Whether a task came to nothing for want of a solver, or of a part of it: the same may work the next time. */
export const isMissing = (ending: Ending): boolean =>
  ending.kind === "lost" || (ending.kind === "refused" && ending.unloaded === true);

export function lost({ message, forbidden, unstarted, advised }: Extract<Ending, { kind: "lost" }>): string {
  if (forbidden) return `The solver cannot run here: ${message}.`;
  if (unstarted && advised) return `The solver could not be started: ${message}.`;
  if (unstarted)
    return `The solver could not be started (${message}). It needs a connection to load, and a browser that allows WebAssembly.`;
  return `The solver stopped unexpectedly (${message}). Your problem is as it was, and another solver is ready.`;
}
