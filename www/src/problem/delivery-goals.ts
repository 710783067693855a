// What there is to deliver: how many packages at once, the sets of packages that are the candidate goals, and which of
// them is true.

import { times } from "./times.js";
import type { DeliveryDocument } from "./types.js";

/** The core takes no more. */
export const MOST_PACKAGES = 64;
export const MOST_SETS = 1024;

export const JOINT = "+";

export const packagesOf = (document: DeliveryDocument): string[] =>
  document.factories.flatMap(({ packages }) => packages);

export const trueGoalOf = (document: DeliveryDocument): string[] => document.true_goal.split(JOINT);

/** How many sets of `chosen` packages there are among `all`. */
export function setCount(all: number, chosen: number): number {
  let count = 1;
  for (let taken = 0; taken < Math.min(chosen, all - chosen); taken += 1) count = (count * (all - taken)) / (taken + 1);
  return all < chosen ? 0 : Math.round(count);
}

/** How many packages may be delivered at once, of so many. */
export function possibleNumbers(packages: number): number[] {
  const numbers = times(packages, (index) => index + 1);
  return numbers.filter((number) => setCount(packages, number) >= 2 && setCount(packages, number) <= MOST_SETS);
}

/** Every candidate goal, as the sets of packages in the document's order. */
export function goalSets(document: DeliveryDocument): string[][] {
  const packages = packagesOf(document);
  const sets: string[][] = [];
  const extend = (set: string[], from: number) => {
    if (set.length === document.deliver) sets.push(set);
    // As many as are still needed must be left.
    const last = packages.length - (document.deliver - set.length);
    for (let next = from; next <= last && set.length < document.deliver; next += 1) {
      extend([...set, packages[next] ?? ""], next + 1);
    }
  };
  extend([], 0);
  return sets;
}

/** The true goal keeps those of its packages that there are still; the first ones that are left fill it up. */
export function withTrueGoal(document: DeliveryDocument, wanted: readonly string[]): DeliveryDocument {
  const packages = packagesOf(document);
  const kept = packages.filter((name) => wanted.includes(name)).slice(0, document.deliver);
  const others = packages.filter((name) => !kept.includes(name));
  const chosen = new Set([...kept, ...others.slice(0, document.deliver - kept.length)]);
  return { ...document, true_goal: packages.filter((name) => chosen.has(name)).join(JOINT) };
}

export const setDeliver = (document: DeliveryDocument, deliver: number): DeliveryDocument | string =>
  possibleNumbers(packagesOf(document).length).includes(deliver)
    ? withTrueGoal({ ...document, deliver }, trueGoalOf(document))
    : tooMany(packagesOf(document).length, deliver);

/** Why so many of so many packages are no problem to set. */
export function tooMany(packages: number, deliver: number): string {
  const count = setCount(packages, deliver);
  if (count < 2) return `With ${packages} packages, ${deliver} to deliver leave nothing to guess.`;
  return `${deliver} of ${packages} packages would make ${count.toLocaleString("en")} candidate goals; at most ${MOST_SETS.toLocaleString("en")} are possible.`;
}
