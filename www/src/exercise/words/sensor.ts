// What an observer is told, and what it knows at first, in words.
import { called, type Role } from "../../view/observers.js";

/** A sentence; one that ends in a colon goes on with a list. */
export type Sentence = string | { said: string; each: readonly string[] };

/** A text that is read as it is. */
export interface Verbatim {
  title: string;
  text: string;
}

/** What the observers know at first and are told of each action. */
export interface Told {
  sentences: readonly Sentence[];
  /** What is a table. */
  texts?: readonly Verbatim[];
}

/** A problem in words. */
export interface InWords {
  /** Where all begins, what can be done, and the goals. */
  sentences: readonly Sentence[];
  texts?: readonly Verbatim[];
  told: Told;
}

export const who = (role: Role): string => `The ${called[role]}`;

/** "“vertical” for north and south". */
export function toldText(symbols: readonly (readonly [action: string, symbol: string])[]): string {
  const bySymbol = new Map<string, string[]>();
  for (const [action, symbol] of symbols) bySymbol.set(symbol, [...(bySymbol.get(symbol) ?? []), action]);
  return [...bySymbol].map(([symbol, actions]) => `“${symbol}” for ${listed(actions)}`).join("; ");
}

/** "one", "one and two", "one, two and three". */
export const listed = (names: readonly string[], last = "and"): string =>
  names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} ${last} ${names.at(-1)}`;

/** The sentence of the true goal, unless it is to be guessed. */
export const trueGoalText = (name: string | undefined): string[] =>
  name === undefined ? [] : [`The true goal: ${name}.`];
