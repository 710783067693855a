// The page, built by Vite into dist/, and the element as one file beside it.
import { run } from "./run.mjs";

/** Resolves to the exit code. */
export async function buildPage(options) {
  const code = await run("vite", ["build", "--logLevel", "warn"], options);
  if (code !== 0) return code;
  // What needs npm packages is loaded here: they may not be there before set-up has run.
  const { buildSingle } = await import("../page/single.mjs");
  return buildSingle(options);
}
