// Starts the worker that the one script holds (it takes the place of start.ts). The core is in it as base64 of
// its gzipped bytes: the page unpacks it once and sends each worker a copy.
import core from "virtual:core";
import { Later, type SolverWorker } from "./later.js";
import { WAITING } from "./names.js";
import type { CoreMessage } from "./protocol.js";
import SolverScript from "./solver.worker.ts?worker&inline";

export type { SolverWorker };

export const startWorker = (): SolverWorker => new Later(start());

let unpacked: Promise<ArrayBuffer> | null = null;

async function start(): Promise<SolverWorker> {
  unpacked ??= unpack();
  const bytes = await unpacked;
  const worker = new SolverScript({ name: WAITING });
  worker.postMessage({ kind: "full", core: bytes } satisfies CoreMessage);
  return worker;
}

function unpack(): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(core), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}
