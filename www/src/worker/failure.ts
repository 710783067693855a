// Telling a person's mistake from a broken core.
import type { Answer } from "./protocol.js";

/** The core names its own errors; a trap, a stack overflow or an error of the glue code means that it is broken. */
const broken = [WebAssembly.RuntimeError, WebAssembly.CompileError, WebAssembly.LinkError, RangeError, TypeError];

export function failure(error: unknown): Answer {
  const message = error instanceof Error ? error.message : String(error);
  return broken.some((kind) => error instanceof kind) ? { kind: "broken", message } : { kind: "refused", message };
}
