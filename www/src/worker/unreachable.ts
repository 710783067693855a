// Why nothing came of an address, as far as a page can tell: browsers keep to themselves what went wrong.
import { forbidsLoading } from "./policy.js";
import { nextTurn } from "./turn.js";

/** What a page can read from. */
const protocols: readonly string[] = ["https:", "http:", "data:", "blob:", "file:"];

export const isReadable = ({ protocol }: URL): boolean => protocols.includes(protocol);

/** What is expected in the place of another address. */
export const READABLE = "an address by https:, http:, data: or blob:, or relative to the page";

interface Reason {
  why: string;
  /** Whether a second try may bring it. */
  mayCome: boolean;
}

export async function whyUnreachable({ href, protocol, origin, host, hostname }: URL): Promise<Reason> {
  const never = (why: string): Reason => ({ why, mayCome: false });
  const onDisk = location.protocol === "file:";
  if (protocol === "file:")
    return never(
      `browsers let a page ${onDisk ? "on a disk read no other file" : "of a host read no file of a disk"}.`,
    );
  // Word of a policy comes after the failure.
  await nextTurn();
  if (forbidsLoading(href))
    return never("the page’s content policy forbids it, and must allow its host in connect-src.");
  if (protocol === "blob:") return never("no such blob is known to this page: it was made by another one, or is gone.");
  if (protocol === "data:") return never("this is no data: address that can be read.");
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
