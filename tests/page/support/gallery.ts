// The gallery's problems, and the core's answers to them.
import { readFileSync } from "node:fs";
import { type Entry, entries } from "../../../www/src/gallery/entries.js";
import { replay, solve } from "./core.js";

const folder = new URL("../../../www/problems/", import.meta.url);

export const documentOf = (name: string): string => readFileSync(new URL(`${name}.json`, folder), "utf8");

export { type Entry, entries };

/** The best goal difference of all plans. */
export const best = (name: string): number | null =>
  solve(documentOf(name), { solver: "exact" }).outcome.goal_difference;

/** What a plan of an entry leads to; for another true goal where the entry names one. */
export function planned(name: string, title: string): { moves: number; difference: number; valid: boolean } {
  const entry = entries.find((other) => other.name === name);
  const named = entry?.plans?.find((plan) => plan.title === title);
  if (named === undefined) throw new Error(`${name} has no plan “${title}”`);
  const text = documentOf(name);
  const document =
    named.trueGoal === undefined ? text : JSON.stringify({ ...JSON.parse(text), true_goal: named.trueGoal });
  const plan = named.plan ?? solve(document, { solver: "exact" }).outcome.plan ?? [];
  const trace = replay(document, [...plan]);
  return { moves: plan.length, difference: trace.goal_difference, valid: trace.valid };
}
