// The facts of a PDDL document, taken apart: `(on a b)`. Names in PDDL have neither spaces nor brackets.
import type { Scene, State } from "../../core.js";

export type PddlScene = Extract<Scene, { format: "pddl" }>;

export interface Atom {
  predicate: string;
  objects: string[];
}

export function atomOf(fact: string): Atom {
  const [predicate = "", ...objects] = fact.replace(/^\(|\)$/g, "").split(" ");
  return { predicate, objects };
}

/** The facts of a state that is a list of facts. */
export const factsOf = (state: State): string[] => (Array.isArray(state) ? (state as unknown[]).map(String) : []);

export const atomsOf = (state: State): Atom[] => factsOf(state).map(atomOf);

/** Whether the domain has a predicate of this name and number of arguments. */
export const hasPredicate = ({ predicates }: PddlScene, name: string, count: number): boolean =>
  predicates.some((predicate) => predicate.name === name && predicate.arguments === count);
