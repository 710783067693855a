// The place of a dialog that is made when it is asked for: beside what the playground draws, where its styles reach it.
import { playgroundAround } from "./surroundings.js";

/** A new element for it, in the colours that the playground has now; `part` is any part of the playground. */
export function besidePlayground(part: Element): HTMLElement {
  const root = part.getRootNode();
  const around = playgroundAround(part);
  const inShadow = root instanceof ShadowRoot && around !== null;
  const element = inShadow ? (around.cloneNode() as HTMLElement) : document.createElement("div");
  element.className = "mo-copp-part";
  element.removeAttribute("part");
  const scheme = around?.dataset.scheme;
  if (scheme !== undefined) element.dataset.scheme = scheme;
  (inShadow ? root : document.body).append(element);
  return element;
}
