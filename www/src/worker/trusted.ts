// The addresses of our own scripts, as a page takes them whose content policy requires Trusted Types.
import { NotLoaded } from "./not-loaded.js";

interface Policy {
  createScriptURL(address: string): string;
}

interface Factory {
  createPolicy(name: string, rules: Policy): Policy;
}

let policy: Policy | undefined;

/** A page that requires nothing may forbid policies all the same: one is made only after an address was refused. */
export function startTrusted(address: string | URL, options: WorkerOptions): Worker {
  const { trustedTypes } = globalThis as { trustedTypes?: Factory };
  if (policy !== undefined) return new Worker(policy.createScriptURL(String(address)), options);
  try {
    return new Worker(address, options);
  } catch (error) {
    if (trustedTypes === undefined || !(error instanceof TypeError)) throw error;
  }
  try {
    policy = trustedTypes.createPolicy("mo-copp", { createScriptURL: (own) => own });
  } catch {
    throw new NotLoaded("trusted-types of the page’s content policy must allow mo-copp");
  }
  return new Worker(policy.createScriptURL(String(address)), options);
}
