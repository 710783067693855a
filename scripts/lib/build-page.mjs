// The page, built by Vite into dist/, and the element as one file beside it.
import { buildSingle } from "../page/single.mjs";
import { run } from "./run.mjs";

/** Resolves to the exit code. */
export const buildPage = async (options) =>
  (await run("vite", ["build", "--logLevel", "warn"], options)) || buildSingle(options);
