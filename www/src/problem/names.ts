// Names that a person types: what they become, and why one can't be taken.

import { unseenIn, visible } from "./unseen.js";

/** No wider label helps anybody. */
export const LONGEST_NAME = 100;

/** Without space around it, and without halves of characters, which the core's JSON can't hold. */
export const tidied = (text: string): string =>
  [...text.trim()]
    .slice(0, LONGEST_NAME)
    .join("")
    .replace(/\p{Surrogate}/gu, "\ufffd")
    .trim();

/** Why a name can't be taken, or null where it can; `others` are the names that are taken. */
export function nameFault(name: string, others: readonly string[]): string | null {
  if (name === "") return "A name is needed.";
  const [unseen] = unseenIn(name);
  if (unseen !== undefined) return `“${visible(name)}” holds ${unseen}, which can’t be seen: take it out.`;
  if (others.includes(name)) return `“${name}” is taken: every name must be its own.`;
  return null;
}

/** The first of some names that is not taken yet. */
export function freeName(taken: readonly string[], candidate: (number: number) => string): string {
  const used = new Set(taken);
  for (let number = 1; ; number += 1) {
    const name = candidate(number);
    if (!used.has(name)) return name;
  }
}
