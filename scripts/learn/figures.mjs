// The problems of the article's figures and their named plans.
import { readdirSync, readFileSync } from "node:fs";
import { inRoot } from "../lib/paths.mjs";

const folder = inRoot("www", "learn", "figures");

/** The names of the problems. */
export const figureNames = () =>
  readdirSync(folder)
    .filter((file) => file.endsWith(".json"))
    .map((file) => file.slice(0, -".json".length))
    .sort();

/** A problem document as its text. */
export const documentOf = (name) => readFileSync(`${folder}/${name}.json`, "utf8");

const plans = () => JSON.parse(readFileSync(inRoot("www", "learn", "plans.json"), "utf8"));

/**
 * The actions of a named plan.
 *
 * @returns {string[]}
 */
export function planOf(name, plan) {
  const actions = plans()[name]?.[plan];
  if (actions === undefined) throw new Error(`${name} has no plan “${plan}”`);
  return actions;
}

/**
 * The named plans of a problem.
 *
 * @returns {Record<string, string[]>}
 */
export const plansOf = (name) => plans()[name] ?? {};
