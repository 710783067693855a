// The addresses of our own scripts, as a page takes them whose content policy requires Trusted Types.
import { NotLoaded } from "./not-loaded.js";

interface Policy {
  createScriptURL(address: string): string;
}

interface Factory {
  createPolicy(name: string, rules: Policy): Policy;
}

/** Undefined before it was asked for, and null where the browser knows none or the page allows none. */
let policy: Policy | null | undefined;

/** The policy comes first: what a page refuses is reported to its host, also where another way is found. */
function policyOf(factory: Factory | undefined): Policy | null {
  try {
    return factory?.createPolicy("mo-copp", { createScriptURL: (own) => own }) ?? null;
  } catch {
    // A page that requires nothing may forbid policies all the same.
    return null;
  }
}

const factory = () => (globalThis as { trustedTypes?: Factory }).trustedTypes;

export function startTrusted(address: string | URL, options: WorkerOptions): Worker {
  policy ??= policyOf(factory());
  if (policy !== null) return new Worker(policy.createScriptURL(String(address)), options);
  try {
    return new Worker(address, options);
  } catch (error) {
    if (factory() === undefined || !(error instanceof TypeError)) throw error;
    throw new NotLoaded("trusted-types of the page’s content policy must allow mo-copp");
  }
}
