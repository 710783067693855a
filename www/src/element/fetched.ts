// The document that `src` names, or why it cannot be had and what would help.
import { LARGEST_DOCUMENT, LARGEST_IN_WORDS } from "../problem/limits.js";
import { brief } from "../view/names.js";
import { forbidsLoading } from "../worker/policy.js";
import { nextTurn } from "../worker/turn.js";

type Fetched =
  | { text: string; fault?: never; mayCome?: never }
  /** `mayCome`: a second try may bring it. */
  | { text?: never; fault: string; mayCome: boolean };

const INSIDE = "A document may stand in the element itself, as a script of the type application/json.";

export async function fetched(given: string): Promise<Fetched> {
  const refused = (why: string, mayCome = false): Fetched => ({
    fault: `The problem document “${brief(given)}” ${why}`,
    mayCome,
  });
  if (given.trim() === "") return { fault: "The attribute src is empty; expected an address.", mayCome: false };
  if (!URL.canParse(given, document.baseURI)) return refused("could not be loaded: this is no address.");
  const address = new URL(given, document.baseURI);
  const tooLarge = `is too large: at most ${LARGEST_IN_WORDS} can be opened.`;
  let text: string;
  try {
    const response = await fetch(address);
    const { ok, status, headers } = response;
    if (!ok) return refused(`could not be loaded: ${address.href} was answered with ${status}.`, true);
    if (Number(headers.get("Content-Length")) > LARGEST_DOCUMENT) return refused(tooLarge);
    text = await response.text();
  } catch {
    const { why, mayCome } = await whyNot(address);
    return refused(`could not be loaded: ${why}`, mayCome);
  }
  if (text.length > LARGEST_DOCUMENT) return refused(tooLarge);
  // No document begins so.
  if (/^\s*</.test(text))
    return refused(`is none: ${address.href} was answered with a page (HTML), and not with JSON.`);
  return { text };
}

/** Why nothing came of an address. */
async function whyNot(address: URL): Promise<{ why: string; mayCome: boolean }> {
  const { href, protocol, origin, host } = address;
  if (protocol === "file:")
    return { why: `browsers let a page on a disk read no other file. ${INSIDE}`, mayCome: false };
  // Word of a policy comes after the failure.
  await nextTurn();
  if (forbidsLoading(href)) {
    const why = `the page’s content policy forbids it, and must allow its host in connect-src. ${INSIDE}`;
    return { why, mayCome: false };
  }
  if (protocol === "http:" && location.protocol === "https:" && !/^(?:localhost|127\.|\[::1\])/.test(host))
    return { why: `a page that came by https can load nothing by http. ${INSIDE}`, mayCome: false };
  if (origin !== globalThis.origin && (await answers(address))) {
    const why = `${host} must send it with “Access-Control-Allow-Origin”, since it is another host than the page’s. ${INSIDE}`;
    return { why, mayCome: false };
  }
  return { why: `${host} does not answer. Check the connection and the address, then try again.`, mayCome: true };
}

/** Whether a host answers, although it lets this page read nothing. */
const answers = (address: URL): Promise<boolean> =>
  fetch(address, { mode: "no-cors" }).then(
    () => true,
    () => false,
  );
