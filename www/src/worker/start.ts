// Starts a worker. On the page's own host it is a file like any other, which every content policy of `'self'` allows;
// from another host, or where the page has no origin, it takes another way (elsewhere.ts), loaded only then.
import { Later, type SolverWorker } from "./later.js";
import { chosenPlaces } from "./places.js";

export type { SolverWorker };

export function startWorker(): SolverWorker {
  if (isElsewhere()) return new Later(import("./elsewhere.js").then(({ startElsewhere }) => startElsewhere()));
  return new Worker(new URL("./solver.worker.ts", import.meta.url), { type: "module", name: "mo-copp solver" });
}

function isElsewhere(): boolean {
  const { worker, wasm } = chosenPlaces();
  if (worker !== null || wasm !== null) return true;
  const { origin } = globalThis;
  return origin !== undefined && new URL(import.meta.url).origin !== origin;
}
