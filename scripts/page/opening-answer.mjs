// The answer to the problem that the page begins with, worked out by the core when the page is built: there is a picture
// before there is a core. How long it took is left out, which is of this machine.
import { readFileSync } from "node:fs";
import { inRoot } from "../lib/paths.mjs";

const id = "virtual:opening-answer";
/** States of one belief that are listed: as many as the worker lists. */
const MOST_STATES = 100;

/** A plugin of Vite. */
export const openingAnswer = () => ({
  name: "opening-answer",
  resolveId: (source) => (source === id ? `\0${id}` : null),
  load: async (found) => (found === `\0${id}` ? `export default ${JSON.stringify(await answer())};` : null),
});

/** The same for a script that has its core inside: there is nothing to wait for. */
export const withoutOpeningAnswer = () => ({
  name: "opening-answer",
  resolveId: (source) => (source === id ? `\0${id}` : null),
  load: (found) => (found === `\0${id}` ? "export default null;" : null),
});

/** Loaded when it is needed: the core must have been built by then. */
export async function answer() {
  const { Problem } = await import("../learn/core.mjs");
  const document = readFileSync(inRoot("www", "problems", "eight-by-eight.json"), "utf8");
  const options = { solver: "exact" };
  const problem = new Problem(document);
  const run = problem.solve(options);
  while (!run.advance(1000));
  const { stats, ...outcome } = run.outcome();
  const { seconds: _, ...counts } = stats;
  const trace = problem.overview(outcome.plan ?? [], MOST_STATES);
  return { options, scene: problem.scene(), outcome: { ...outcome, stats: counts }, trace };
}
