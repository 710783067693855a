// Starts the worker that the one script holds (it takes the place of start.ts). The core is in it as base64 of
// its bytes, packed by LZMA, which makes a quarter less of them than gzip: the page unpacks it once and sends each worker
// a copy.
import core from "virtual:core";
import { decompress } from "virtual:lzma";
import { Later, type SolverWorker } from "./later.js";
import { NAME } from "./names.js";
import { NotLoaded } from "./not-loaded.js";
import type { CoreMessage } from "./protocol.js";
import SolverScript from "./solver.worker.ts?worker&inline";

export type { SolverWorker };

export const startWorker = (): SolverWorker => new Later(start());

let unpacked: Uint8Array<ArrayBuffer> | null = null;

async function start(): Promise<SolverWorker> {
  // Unpacking takes as long as a few pictures: the page draws what it has before.
  await new Promise((done) => setTimeout(done));
  unpacked ??= unpack();
  const worker = started();
  worker.postMessage({ kind: "full", core: unpacked.buffer } satisfies CoreMessage);
  return worker;
}

function started(): Worker {
  try {
    return new SolverScript({ name: NAME });
  } catch (error) {
    if (!/TrustedScriptURL/.test(String(error))) throw error;
    throw new NotLoaded("the page’s content policy requires Trusted Types: the element as a folder can run there");
  }
}

function unpack(): Uint8Array<ArrayBuffer> {
  const packed = Uint8Array.from(atob(core), (letter) => letter.charCodeAt(0));
  return new Uint8Array(decompress(packed));
}
