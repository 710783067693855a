// The document that `src` names, or why it cannot be had and what would help.
import { LARGEST_DOCUMENT, LARGEST_IN_WORDS } from "../problem/limits.js";
import { brief } from "../view/names.js";
import { isReadable, READABLE, whyUnreachable } from "../worker/unreachable.js";

type Fetched =
  | { text: string; fault?: never; mayCome?: never }
  /** `mayCome`: a second try may bring it. */
  | { text?: never; fault: string; mayCome: boolean };

/** A host that has said nothing by then says nothing. */
const PATIENCE_MS = 30_000;

const INSIDE = "A document may stand in the element itself, as a script of the type application/json.";

export async function fetched(given: string): Promise<Fetched> {
  const refused = (why: string, mayCome = false): Fetched => ({
    fault: `The problem document “${brief(given)}” ${why}`,
    mayCome,
  });
  if (given.trim() === "") return { fault: "The attribute src is empty; expected an address.", mayCome: false };
  if (!URL.canParse(given, document.baseURI)) return refused("could not be loaded: this is no address.");
  const address = new URL(given, document.baseURI);
  if (!isReadable(address))
    return refused(`could not be loaded: “${address.protocol}” is no place of documents; expected ${READABLE}.`);
  const tooLarge = `is too large: at most ${LARGEST_IN_WORDS} can be opened.`;
  let text: string;
  const patience = new AbortController();
  const timer = setTimeout(() => patience.abort(), PATIENCE_MS);
  try {
    const response = await fetch(address, { signal: patience.signal });
    clearTimeout(timer);
    const { ok, status, headers } = response;
    if (!ok) return refused(`could not be loaded: ${address.href} was answered with ${status}.`, true);
    if (Number(headers.get("Content-Length")) > LARGEST_DOCUMENT) return refused(tooLarge);
    text = await response.text();
  } catch {
    if (patience.signal.aborted)
      return refused(`could not be loaded: ${address.href} did not answer in ${PATIENCE_MS / 1000} seconds.`, true);
    clearTimeout(timer);
    const { why, mayCome } = await whyUnreachable(address);
    return refused(`could not be loaded: ${why}${mayCome ? "" : ` ${INSIDE}`}`, mayCome);
  }
  if (text.length > LARGEST_DOCUMENT) return refused(tooLarge);
  // No document begins so.
  if (/^\s*</.test(text))
    return refused(`is none: ${address.href} was answered with a page (HTML), and not with JSON.`);
  return { text };
}
