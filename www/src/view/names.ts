// Names of a document, as the page shows them: each sign of them can be seen, and none turns the text around it.
import { visible } from "../problem/unseen.js";

export { visible };

const LONGEST = 40;

/** Letters that are written from the right: beside them marks and numbers would change their places. */
const fromRight = /[\u0590-\u08ff\ufb1d-\ufdff\ufe70-\ufefc\u{10800}-\u{10fff}\u{1e800}-\u{1efff}]/u;

/** In running text: the name keeps its own direction, and the text its own. */
export function named(name: string): string {
  const shown = visible(name);
  return fromRight.test(shown) ? `\u2068${shown}\u2069` : shown;
}

/** A very long name would hide the sentence it stands in; the lists have it in full. */
export function brief(name: string): string {
  const letters = [...visible(name)];
  return named(letters.length <= LONGEST ? letters.join("") : `${letters.slice(0, LONGEST - 1).join("")}…`);
}
