// Starts a worker. On the page's own host it is a file like any other, which every content policy of `'self'` allows;
// from another host, or where the page has no origin, it takes another way (elsewhere.ts), loaded only then.
import { Later, type SolverWorker } from "./later.js";
import { NAME } from "./names.js";
import { chosenPlaces } from "./places.js";
import type { CoreMessage } from "./protocol.js";
import { Refusable } from "./refusable.js";
import { startTrusted } from "./trusted.js";

export type { SolverWorker };

export function startWorker(): SolverWorker {
  if (isElsewhere()) return elsewhere();
  let worker: globalThis.Worker;
  try {
    worker = new Worker(new URL("./solver.worker.ts", import.meta.url), { type: "module", name: NAME }).started;
  } catch {
    return elsewhere();
  }
  // A bundler that takes the element in gives files new names, and tells them to modules of the page alone.
  const light = new URL("../../pkg-light/mo_copp_light_bg.wasm", import.meta.url).href;
  const full = new URL("../../pkg/mo_copp_bg.wasm", import.meta.url).href;
  worker.postMessage({ kind: "light", core: light } satisfies CoreMessage);
  worker.postMessage({ kind: "full", core: full } satisfies CoreMessage);
  return new Refusable(worker, () => import("./elsewhere.js").then(({ startCopy }) => startCopy()));
}

/** Under this name a bundler finds the script of a worker. */
class Worker {
  readonly started: globalThis.Worker;

  constructor(address: URL, options: WorkerOptions) {
    this.started = startTrusted(address, options);
  }
}

const elsewhere = (): SolverWorker =>
  new Later(import("./elsewhere.js").then(({ startElsewhere }) => startElsewhere()));

function isElsewhere(): boolean {
  const { worker, wasm } = chosenPlaces();
  if (worker !== null || wasm !== null) return true;
  const { origin } = globalThis;
  return origin !== undefined && new URL(import.meta.url).origin !== origin;
}
