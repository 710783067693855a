// Where everything is: in one state for certain, in a belief with the number of states in which it is there.
import type { BeliefSummary, State } from "../../core.js";
import { atomOf, factsOf } from "../pddl/atoms.js";

/** Something at a place or in a vehicle. */
export interface Stay {
  name: string;
  /** In how many of the states: of one state, 1. */
  states: number;
  /** Drives what it is in. */
  drives: boolean;
}

export interface Load {
  /** What is at each place, and in each vehicle. */
  stays: ReadonlyMap<string, readonly Stay[]>;
  /** How many states this is about. */
  of: number;
}

export const loadOfState = (state: State): Load =>
  loaded(
    factsOf(state).map((fact) => ({ fact, states: 1 })),
    1,
  );

export const loadOfBelief = ({ shares, states }: BeliefSummary): Load =>
  loaded(
    shares.flatMap((share) => ("fact" in share ? [{ fact: share.fact, states: share.states }] : [])),
    states,
  );

function loaded(facts: readonly { fact: string; states: number }[], of: number): Load {
  const stays = new Map<string, Stay[]>();
  for (const { fact, states } of facts) {
    const { predicate, objects } = atomOf(fact);
    const [name, where] = objects;
    if (name === undefined || where === undefined || objects.length !== 2 || !spatial.has(predicate)) continue;
    const list = stays.get(where) ?? [];
    list.push({ name, states, drives: predicate === "driving" });
    stays.set(where, list);
  }
  for (const list of stays.values()) list.sort((a, b) => Number(b.drives) - Number(a.drives) || byName(a.name, b.name));
  return { stays, of };
}

const spatial = new Set(["at", "in", "driving"]);
const { compare: byName } = new Intl.Collator("en", { numeric: true });
