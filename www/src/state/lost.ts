// What is said of a worker that was lost.
import type { Ending } from "../worker/client.js";

export const lost = ({ message, forbidden }: Extract<Ending, { kind: "lost" }>): string =>
  forbidden
    ? `The solver cannot run here: ${message}.`
    : `The solver stopped unexpectedly (${message}). Your problem is as it was, and another solver is ready.`;
