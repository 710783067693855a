// Telling a person's mistake from a broken core.
import type { DocumentError } from "../core.js";
import { isForbiddenWasm, NO_WASM } from "./policy.js";
import type { Answer, Fault } from "./protocol.js";

/** The core names its own errors; a trap, a stack overflow or an error of the glue code means that it is broken. */
const broken = [WebAssembly.RuntimeError, WebAssembly.CompileError, WebAssembly.LinkError, RangeError, TypeError];

/** What is needed could not be loaded: the core at work is as good as before. */
export class NotLoaded extends Error {}

export function failure(error: unknown): Answer {
  if (isForbiddenWasm(error)) return { kind: "broken", message: NO_WASM, forbidden: true };
  const message = error instanceof Error ? error.message : String(error);
  if (error instanceof NotLoaded) return { kind: "refused", message, unloaded: true };
  return broken.some((kind) => error instanceof kind) ? { kind: "broken", message } : { kind: "refused", message };
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
