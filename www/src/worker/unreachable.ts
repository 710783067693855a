// Why nothing came of an address, as far as a page can tell: browsers keep to themselves what went wrong.
import { forbidsLoading } from "./policy.js";
import { nextTurn } from "./turn.js";

interface Reason {
  why: string;
  /** Whether a second try may bring it. */
  mayCome: boolean;
}

export async function whyUnreachable({ href, protocol, origin, host, hostname }: URL): Promise<Reason> {
  const never = (why: string): Reason => ({ why, mayCome: false });
  if (protocol === "file:") return never("browsers let a page on a disk read no other file.");
  // Word of a policy comes after the failure.
  await nextTurn();
  if (forbidsLoading(href))
    return never("the page’s content policy forbids it, and must allow its host in connect-src.");
  if (protocol === "http:" && location.protocol === "https:" && !isHere(hostname))
    return never("a page that came by https can load nothing by http.");
  if (origin !== globalThis.origin && (await answers(href)))
    return never(`${host} must send it with “Access-Control-Allow-Origin”, since it is another host than the page’s.`);
  return { why: `${host} does not answer. Check the connection and the address, then try again.`, mayCome: true };
}

/** Hosts that browsers trust without https. */
const isHere = (hostname: string): boolean => /^(?:localhost|.*\.localhost|127\..*|\[::1\])$/.test(hostname);

/** Whether a host answers, although it lets this page read nothing. */
const answers = (href: string): Promise<boolean> =>
  fetch(href, { mode: "no-cors" }).then(
    () => true,
    () => false,
  );
