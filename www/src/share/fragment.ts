// What stands behind the # of an address: a playground's state, or a place of the page.
import { isWhole } from "./packed.js";

/**
 * Whether a fragment is a playground's: as `pack` writes it, or what is left of such a one that was cut off, changed or
 * made by a newer version. What is packed is long and has no words, and so no place of a page is taken for it
 * (`1.5`, `2.1-results`, `1.introduction-to-planning`).
 */
export const isOwn = (fragment: string): boolean =>
  isWhole(fragment) || (isLikeOwn.test(fragment) && isMixed(fragment));

const isLikeOwn = /^\d{1,6}\.[\w-]{40,}(?:\.[a-z0-9]*)?$/;

/** Whether some run of letters is too long for a word, and mixed as none is. */
const isMixed = (fragment: string): boolean =>
  (fragment.match(/[A-Za-z0-9]{16,}/g) ?? []).some((run) => /[a-z]/.test(run) && /[A-Z]/.test(run) && /\d/.test(run));

/** Whether the page has the place that a fragment names, as a browser finds it (HTML, "find a potential indicated element"). */
export function leadsSomewhere(fragment: string): boolean {
  return [fragment, decoded(fragment)].some(
    (name) =>
      name.toLowerCase() === "top" ||
      document.getElementById(name) !== null ||
      document.querySelector(`a[name="${CSS.escape(name)}"]`) !== null,
  );
}

function decoded(fragment: string): string {
  try {
    return decodeURIComponent(fragment);
  } catch {
    return fragment;
  }
}
