// Telling a person's mistake from a broken core.
import type { DocumentError } from "../core.js";
import { NotLoaded } from "./not-loaded.js";
import { isForbiddenWasm, NO_WASM } from "./policy.js";
import type { Answer, Fault } from "./protocol.js";

/** The core names its own errors; a trap, a stack overflow or an error of the glue code means that it is broken. */
const broken = [WebAssembly.RuntimeError, WebAssembly.CompileError, WebAssembly.LinkError, RangeError, TypeError];

export function failure(error: unknown): Answer {
  if (isForbiddenWasm(error)) return { kind: "broken", message: NO_WASM, forbidden: true };
  const message = error instanceof Error ? error.message : String(error);
  // The core at work is as good as before.
  if (error instanceof NotLoaded) return { kind: "refused", message, unloaded: true };
  return broken.some((kind) => error instanceof kind) ? { kind: "broken", message } : { kind: "refused", message };
}

/** Of a worker that never had a core: another one may have. */
export function unstarted(error: unknown): Answer {
  const answer = failure(error);
  if (answer.kind !== "refused") return answer;
  return { kind: "broken", message: answer.message, ...(answer.unloaded ? { advised: true } : {}) };
}

/** What a document's own error says; null where the error is another. */
export function faultIn(error: unknown): Fault | null {
  if (!(error instanceof Error) || error.name !== "DocumentError") return null;
  const { message, place, path, line, column, found, expected } = error as DocumentError;
  return {
    message,
    place,
    ...(path === undefined ? {} : { path }),
    ...(line === undefined || column === undefined ? {} : { line, column }),
    ...(found === undefined || expected === undefined ? {} : { found, expected }),
  };
}
