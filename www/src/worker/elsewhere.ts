// A worker for a page of another host, or of none: browsers start no worker from there. Its script is fetched and started
// as a `blob:` (or, where a page may not have one, as a `data:`), and the page fetches the core for it: not every browser
// lets such a worker fetch by itself.

import fullAddress from "../../pkg/mo_copp_bg.wasm?url";
import lightAddress from "../../pkg-light/mo_copp_light_bg.wasm?url";
import type { SolverWorker } from "./later.js";
import { NAME } from "./names.js";
import { chosenPlaces } from "./places.js";
import type { CoreMessage, Reply } from "./protocol.js";
import workerAddress from "./solver.worker.ts?worker&url";

const texts = new Map<string, Promise<string>>();
const cores = new Map<string, Promise<ArrayBuffer>>();

export async function startElsewhere(): Promise<SolverWorker> {
  const { worker, wasm } = chosenPlaces();
  const address = new URL(worker ?? workerAddress, document.baseURI);
  const started =
    address.origin === globalThis.origin ? fromFile(address) : fromText(await once(texts, address.href, text));
  return supply(started, wasm === null ? { light: lightAddress, full: fullAddress } : { light: null, full: wasm });
}

const fromFile = (address: URL): Worker => new Worker(address, { name: NAME });

export function fromText(script: string): Worker {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  try {
    return new Worker(address, { name: NAME });
  } catch {
    return new Worker(`data:text/javascript;base64,${inBase64(script)}`, { name: NAME });
  } finally {
    // The browser has read it by the time that the worker says anything.
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
  }
}

const inBase64 = (text: string): string =>
  btoa(Array.from(new TextEncoder().encode(text), (byte) => String.fromCharCode(byte)).join(""));

/** Sends the worker the cores: the light one at once, the full one when it asks, or that one alone. */
function supply(worker: Worker, { light, full }: { light: string | null; full: string }): Worker {
  const send = (kind: CoreMessage["kind"], address: string) =>
    once(cores, new URL(address, document.baseURI).href, bytes).then(
      (core) => worker.postMessage({ kind, core } satisfies CoreMessage),
      (error: Error) => worker.postMessage({ kind, core: null, error: error.message } satisfies CoreMessage),
    );
  worker.addEventListener("message", ({ data }: MessageEvent<Reply>) => {
    if (data.kind === "ask") void send("full", full);
  });
  if (light !== null) void send("light", light);
  else void send("full", full);
  return worker;
}

/** One fetch for all workers; one that failed is tried again by the next. */
function once<T>(
  known: Map<string, Promise<T>>,
  address: string,
  read: (response: Response) => Promise<T>,
): Promise<T> {
  let found = known.get(address);
  if (found === undefined) {
    found = fetched(address).then(read);
    found.catch(() => known.delete(address));
    known.set(address, found);
  }
  return found;
}

const text = (response: Response) => response.text();
const bytes = (response: Response) => response.arrayBuffer();

async function fetched(address: string): Promise<Response> {
  try {
    const response = await fetch(address);
    if (response.ok) return response;
  } catch {
    // Said below.
  }
  throw new Error(
    `${address} could not be loaded; its host must send it with “Access-Control-Allow-Origin”, and the page’s policy allow it in connect-src`,
  );
}
