// Text in an address: `1.TEXT.CHECK`, where TEXT is deflated (RFC 1951) and written in base64url, and CHECK is a sum
// over it, so that a link that was cut off or damaged on its way is known before anything is made of it.

/** The version of what stands in an address. */
const VERSION = 1;

/** Browsers take more, programs that pass links on do not. */
export const LONGEST_LINK = 60_000;
/** Some kilobytes of deflated text can be gigabytes. What is larger than this has no link as short as it must be. */
export const MOST_TEXT = 2_000_000;
/** What is inflated in one piece; deflated text grows to at most about a thousand times its size. */
const PIECE = 1024;

/** Version, text and sum. */
const parts = /^(\d{1,6})\.([A-Za-z0-9_-]*)(?:\.([a-z0-9]*))?$/;

/** Why a link can't be read: the message is for the person. */
export class LinkError extends Error {}

export async function pack(text: string): Promise<string> {
  const deflated = await collect(
    pieces(new TextEncoder().encode(text)),
    new CompressionStream("deflate-raw"),
    MOST_TEXT,
  );
  const packed = toBase64Url(deflated);
  return `${VERSION}.${packed}.${checksum(packed)}`;
}

export async function unpack(fragment: string): Promise<string> {
  const [, version, packed = "", check] = parts.exec(fragment) ?? [];
  if (version === undefined) throw new LinkError("This link is damaged: it does not read like one of this page’s.");
  if (Number(version) > VERSION) {
    throw new LinkError(
      "This link was made by a newer version of the page. Reload the page, or use its newest address.",
    );
  }
  if (Number(version) < VERSION || packed.length > LONGEST_LINK) throw new LinkError("This link is damaged.");
  if (check !== checksum(packed)) throw new LinkError("This link is damaged: a part of it is missing or changed.");
  const bytes = fromBase64Url(packed);
  try {
    const inflated = await collect(pieces(bytes), new DecompressionStream("deflate-raw"), MOST_TEXT);
    return new TextDecoder("utf-8", { fatal: true }).decode(inflated);
  } catch (error) {
    if (error instanceof LinkError) throw error;
    throw new LinkError("This link is damaged.");
  }
}

/** Whether a fragment is one of this version, without damage. */
export function isWhole(fragment: string): boolean {
  const [, version, packed = "", check] = parts.exec(fragment) ?? [];
  return Number(version) === VERSION && packed !== "" && check === checksum(packed);
}

/** In small pieces, so that what comes out of each can be counted before the next goes in. */
function pieces(bytes: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0;
  return new ReadableStream({
    pull(controller) {
      if (at >= bytes.length) controller.close();
      else controller.enqueue(bytes.slice(at, at + PIECE));
      at += PIECE;
    },
  });
}

async function collect(
  source: ReadableStream<Uint8Array<ArrayBuffer>>,
  transform: CompressionStream | DecompressionStream,
  most: number,
): Promise<Uint8Array<ArrayBuffer>> {
  const parts: Uint8Array[] = [];
  let size = 0;
  const reader = source.pipeThrough(transform).getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) {
      await reader.cancel();
      throw new LinkError("This link holds more than any problem that can be shown.");
    }
    parts.push(value);
  }
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

function toBase64Url(bytes: Uint8Array): string {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function fromBase64Url(text: string): Uint8Array<ArrayBuffer> {
  try {
    const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
    return Uint8Array.from(binary, (character) => character.charCodeAt(0));
  } catch {
    throw new LinkError("This link is damaged.");
  }
}

/** FNV-1a over the characters: not against malice, only against accidents. */
function checksum(text: string): string {
  let sum = 0x811c9dc5;
  for (let at = 0; at < text.length; at += 1) sum = Math.imul(sum ^ text.charCodeAt(at), 0x01000193);
  return (sum >>> 0).toString(36);
}
