// What is said of a worker that was lost.
import type { Ending } from "../worker/client.js";

export function lost({ message, forbidden, unstarted }: Extract<Ending, { kind: "lost" }>): string {
  if (forbidden) return `The solver cannot run here: ${message}.`;
  if (unstarted)
    return `The solver could not be started (${message}). It needs a connection to load, and a browser that allows WebAssembly.`;
  return `The solver stopped unexpectedly (${message}). Your problem is as it was, and another solver is ready.`;
}
