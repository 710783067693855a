// A worker for a page of another host, or of none: browsers start no worker from there. Its script is fetched and started
// as a `blob:` (or, where a page may not have one, as a `data:`), and the page fetches the core for it: not every browser
// lets such a worker fetch by itself.

import fullAddress from "../../pkg/mo_copp_bg.wasm?url";
import lightAddress from "../../pkg-light/mo_copp_light_bg.wasm?url";
import type { SolverWorker } from "./later.js";
import { NAME } from "./names.js";
import { faultOf, NotLoaded } from "./not-loaded.js";
import { chosenPlaces } from "./places.js";
import type { CoreMessage, Reply } from "./protocol.js";
import { Refusable } from "./refusable.js";
import workerAddress from "./solver.worker.ts?worker&url";
import { startTrusted } from "./trusted.js";
import { isReadable, READABLE, whyUnreachable } from "./unreachable.js";

type Attribute = "worker-url" | "wasm-url";

const texts = new Map<string, Promise<string>>();
const cores = new Map<string, Promise<ArrayBuffer>>();

export async function startElsewhere(): Promise<SolverWorker> {
  const address = scriptAddress();
  if (address.origin !== globalThis.origin) return startCopy();
  return new Refusable(
    supplied(() => fromFile(address)),
    startCopy,
  );
}

/** From the text of the script, wherever that is. */
export async function startCopy(): Promise<SolverWorker> {
  const script = await once(texts, scriptAddress(), "worker-url", text);
  return supplied(() => fromText(script));
}

const scriptAddress = (): URL =>
  addressOf(chosenPlaces().worker, "worker-url") ?? new URL(workerAddress, document.baseURI);

function supplied(start: () => Worker): Worker {
  const core = addressOf(chosenPlaces().wasm, "wasm-url");
  if (core !== null) return supply(start(), { light: null, full: core });
  const [light, full] = [lightAddress, fullAddress].map((file) => new URL(file, document.baseURI)) as [URL, URL];
  return supply(start(), { light, full });
}

function addressOf(given: string | null, attribute: Attribute): URL | null {
  if (given === null) return null;
  const refused = (expected: string) =>
    new NotLoaded(`“${given}” can’t be used for the attribute ${attribute}; expected ${expected}`);
  if (given.trim() === "" || !URL.canParse(given, document.baseURI)) throw refused("an address");
  const address = new URL(given, document.baseURI);
  if (!isReadable(address)) throw refused(READABLE);
  return address;
}

const fromFile = (address: URL): Worker => startTrusted(address, { name: NAME });

export function fromText(script: string): Worker {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  try {
    return startTrusted(address, { name: NAME });
  } catch (error) {
    if (error instanceof NotLoaded) throw error;
    return new Worker(`data:text/javascript;base64,${inBase64(script)}`, { name: NAME });
  } finally {
    // The browser has read it by the time that the worker says anything.
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
  }
}

const inBase64 = (text: string): string =>
  btoa([...new TextEncoder().encode(text)].map((byte) => String.fromCharCode(byte)).join(""));

/** Sends the worker the cores: the light one at once, the full one when it asks, or that one alone. */
function supply(worker: Worker, { light, full }: { light: URL | null; full: URL }): Worker {
  const send = (kind: CoreMessage["kind"], address: URL) =>
    once(cores, address, "wasm-url", bytes).then(
      (core) => worker.postMessage({ kind, core } satisfies CoreMessage),
      (error: Error) => worker.postMessage({ kind, core: null, error: error.message } satisfies CoreMessage),
    );
  worker.addEventListener("message", ({ data }: MessageEvent<Reply>) => {
    if (data?.kind === "ask") void send("full", full);
  });
  if (light !== null) void send("light", light);
  else void send("full", full);
  return worker;
}

/** One fetch for all workers; one that failed is tried again by the next. */
function once<T>(
  known: Map<string, Promise<T>>,
  address: URL,
  attribute: Attribute,
  read: (response: Response) => Promise<T>,
): Promise<T> {
  const { href } = address;
  let found = known.get(href);
  if (found === undefined) {
    found = fetched(address, attribute).then(read);
    found.catch(() => known.delete(href));
    known.set(href, found);
  }
  return found;
}

const text = (response: Response) => response.text();

async function bytes(response: Response): Promise<ArrayBuffer> {
  const core = await response.arrayBuffer();
  const { wasm } = chosenPlaces();
  const begins = String.fromCharCode(...new Uint8Array(core, 0, Math.min(4, core.byteLength)));
  if (begins === "\0asm") return core;
  throw new NotLoaded(`${response.url} is no WebAssembly${named(wasm, "wasm-url")}`);
}

/** Who placed a file that is not right: the page may have, by an attribute. */
const named = (placed: string | null, attribute: Attribute): string =>
  placed === null ? "" : `; ${attribute} names it`;

async function fetched(address: URL, attribute: Attribute): Promise<Response> {
  const placed = chosenPlaces()[attribute === "wasm-url" ? "wasm" : "worker"];
  let response: Response;
  try {
    response = await fetch(address);
  } catch {
    const { why } = await whyUnreachable(address);
    const from = placed === null ? "" : `, which ${attribute} names,`;
    throw new NotLoaded(`${address.href}${from} could not be loaded: ${why.replace(/\.$/, "")}`);
  }
  const fault = faultOf(response);
  if (fault !== null) throw new NotLoaded(`${fault}${named(placed, attribute)}`);
  return response;
}
