// What is said of a worker that was lost.
import type { Ending } from "../worker/client.js";

export const lost = ({ message, unstarted }: Extract<Ending, { kind: "lost" }>): string =>
  unstarted
    ? `The solver could not be started (${message}). It needs a connection to load, and a browser that allows WebAssembly.`
    : `The solver stopped unexpectedly (${message}). Your problem is as it was, and another solver is ready.`;
