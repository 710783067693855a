// The playground around a part of it, wherever it is drawn: into the document, or into a shadow root of its own.

/** What the playground that `part` stands in is drawn into; null outside of any. */
export const playgroundAround = (part: Element): HTMLElement | null =>
  part.closest<HTMLElement>("mo-copp-playground, .mo-copp-part");

/** What has the focus, also inside of shadow roots. */
export function focused(): Element | null {
  let at = document.activeElement;
  while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
  return at;
}
