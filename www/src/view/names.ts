// Names of a document in running text.

const LONGEST = 40;

/** A very long name would hide the sentence it stands in; the lists have it in full. */
export function brief(name: string): string {
  const letters = Array.from(name);
  return letters.length <= LONGEST ? name : `${letters.slice(0, LONGEST - 1).join("")}…`;
}
