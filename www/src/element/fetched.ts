// The document that `src` names, or why it cannot be had and what would help.
import { LARGEST_DOCUMENT, LARGEST_IN_WORDS } from "../problem/limits.js";
import { brief } from "../view/names.js";
import { isReadable, READABLE, whyUnreachable } from "../worker/unreachable.js";

type Fetched =
  | { text: string; fault?: never; mayCome?: never }
  /** `mayCome`: a second try may bring it. */
  | { text?: never; fault: string; mayCome: boolean };

/** A host that has sent nothing for so long sends nothing more. */
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
  const stop = new AbortController();
  const patience = new Patience(PATIENCE_MS, stop);
  let response: Response | null = null;
  let text: string | null;
  try {
    response = await fetch(address, { signal: stop.signal });
    const { ok, status, headers } = response;
    if (!ok) return refused(`could not be loaded: ${address.href} was answered with ${status}.`, true);
    if (Number(headers.get("Content-Length")) > LARGEST_DOCUMENT) return refused(tooLarge);
    text = await textOf(response, patience);
    if (text === null) return refused(tooLarge);
  } catch {
    patience.end();
    if (stop.signal.aborted)
      return refused(`could not be loaded: ${address.href} did not answer in ${PATIENCE_MS / 1000} seconds.`, true);
    if (response !== null)
      return refused(`could not be loaded: ${address.href} broke off. Check the connection, then try again.`, true);
    const { why, mayCome } = await whyUnreachable(address);
    return refused(`could not be loaded: ${why}${mayCome ? "" : ` ${INSIDE}`}`, mayCome);
  } finally {
    patience.end();
    // What is left of an answer that is refused need not come.
    stop.abort();
  }
  // No document begins so.
  if (/^\s*</.test(text))
    return refused(`is none: ${address.href} was answered with a page (HTML), and not with JSON.`);
  return { text };
}

/** Stops what sends nothing for a while. */
class Patience {
  private timer = 0;

  constructor(
    private readonly milliseconds: number,
    private readonly stop: AbortController,
  ) {
    this.renew();
  }

  renew(): void {
    this.end();
    this.timer = window.setTimeout(() => this.stop.abort(), this.milliseconds);
  }

  end(): void {
    clearTimeout(this.timer);
  }
}

/** The text of an answer, read part by part; null as soon as it is too large. */
async function textOf({ body }: Response, patience: Patience): Promise<string | null> {
  const decoder = new TextDecoder();
  const reader = body?.getReader();
  let text = "";
  for (let bytes = 0; ; ) {
    patience.renew();
    const { value } = (await reader?.read()) ?? {};
    if (value === undefined) return text + decoder.decode();
    bytes += value.length;
    if (bytes > LARGEST_DOCUMENT) return null;
    text += decoder.decode(value, { stream: true });
  }
}
