// What a page's content policy forbids. A worker that it forbids only fails, without a word of why: the violations that
// the browser tells the page are remembered.

let workers = false;
/** What was not to be loaded: an address, or a host alone. */
const loads = new Set<string>();

globalThis.document?.addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) => {
  if (effectiveDirective === "worker-src") workers = true;
  if (effectiveDirective === "connect-src") loads.add(blockedURI);
});

/** Why no worker was started; null where no policy was in the way. */
export function whyForbidden(): string | null {
  if (!workers) return null;
  return "the page’s content policy forbids its worker, and must allow worker-src 'self', or blob: for a playground of another host or of one file";
}

/** Whether the page may not load what is at an address, as far as that was tried. */
export const forbidsLoading = (address: string): boolean => [...loads].some((blocked) => address.startsWith(blocked));

export const NO_WASM = "the page’s content policy forbids WebAssembly, and must allow 'wasm-unsafe-eval' in script-src";

/** Whether an error is the browser's word that a policy forbids WebAssembly. */
export const isForbiddenWasm = (error: unknown): boolean =>
  error instanceof WebAssembly.CompileError && /policy|unsafe-eval|disallowed/i.test(error.message);
