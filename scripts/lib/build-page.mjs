// The page, built by Vite into dist/.
import { run } from "./run.mjs";

/** Resolves to the exit code. */
export const buildPage = () => run("vite", ["build", "--logLevel", "warn"]);
