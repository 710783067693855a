// Something that did not come from its address.

/** What is needed could not be loaded. The message says why, and what helps. */
export class NotLoaded extends Error {}

/** What is wrong with an answer of a host, before it is read; null where nothing is. */
export function faultOf({ ok, status, url, headers }: Response): string | null {
  if (!ok) return `${url} was answered with ${status}`;
  return /\bhtml\b/.test(headers.get("Content-Type") ?? "") ? `${url} was answered with a page (HTML)` : null;
}
