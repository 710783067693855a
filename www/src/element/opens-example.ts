// Whether an element begins with the problem that the page brings, for which there is an answer before there is a core.
import type { Wanted } from "./given.js";
import { inline } from "./settings.js";

/** `isLinked`: the page's address is this playground's, and names a problem. */
export function opensExample(host: HTMLElement, { document, state }: Wanted, isLinked: boolean): boolean {
  if (document !== null || state !== null || isLinked) return false;
  return !["src", "problem", "exercise"].some((name) => host.hasAttribute(name)) && inline(host) === null;
}
