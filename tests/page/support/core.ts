// The core, run here in Node: what the page shows is held against its answers.
import { readFileSync } from "node:fs";
import init, { Exercise, Problem, seedOf } from "../../../www/pkg/mo_copp.js";
import type { Advice, Outcome, PictureOptions, Scene, SolveOptions, Trace } from "../../../www/src/core.js";

export { Exercise, seedOf };

const folder = new URL("../../../www/", import.meta.url);
await init({ module_or_path: readFileSync(new URL("pkg/mo_copp_bg.wasm", folder)) });

export const example: string = readFileSync(new URL("problems/eight-by-eight.json", folder), "utf8");

export function solve(document: string, options: SolveOptions): { outcome: Outcome; trace: Trace } {
  const problem = new Problem(document);
  const run = problem.solve(options);
  while (!run.advance(10_000));
  const outcome = run.outcome();
  return { outcome, trace: problem.trace(outcome.plan ?? []) };
}

export function replay(document: string, plan: string[]): Trace {
  return new Problem(document).trace(plan);
}

export const picture = (document: string, plan: string[], options: PictureOptions): string =>
  new Problem(document).picture(plan, options);

export function advise(document: string, options: SolveOptions): Advice {
  const run = new Problem(document).remedy(options);
  while (!run.advance(10_000));
  return run.outcome();
}

export const scene = (document: string): Scene => new Problem(document).scene();

/** True where the core takes the document, else why it does not. */
export function taken(document: string): true | string {
  try {
    new Problem(document).free();
    return true;
  } catch (error) {
    return String(error);
  }
}
