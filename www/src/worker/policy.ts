// What a page's content policy forbids. A worker that it forbids only fails, without a word of why: the violations that
// the browser tells the page are remembered.

let workers = false;

globalThis.document?.addEventListener("securitypolicyviolation", ({ effectiveDirective }) => {
  if (effectiveDirective === "worker-src") workers = true;
});

/** Why no worker was started; null where no policy was in the way. */
export function whyForbidden(): string | null {
  if (!workers) return null;
  return "the page’s content policy forbids its worker, and must allow worker-src 'self', or blob: for a playground of another host or of one file";
}

export const NO_WASM = "the page’s content policy forbids WebAssembly, and must allow 'wasm-unsafe-eval' in script-src";

/** Whether an error is the browser's word that a policy forbids WebAssembly. */
export const isForbiddenWasm = (error: unknown): boolean =>
  error instanceof WebAssembly.CompileError && /policy|unsafe-eval|disallowed/i.test(error.message);
