// The author kits: pages built by the tools that they are for, opened in Chromium.
import { readdirSync } from "node:fs";
import { inRoot } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";

/** Ends a file that hangs. */
const LIMIT_MS = 600_000;

/** Resolves to the exit code. */
export function kitTests(options = {}) {
  const folder = inRoot("tests", "kits");
  const files = readdirSync(folder).filter((file) => file.endsWith(".test.ts"));
  const args = [
    ...["--import", "tsx", "--test", "--test-reporter=spec", "--test-force-exit"],
    ...["--disable-warning=ExperimentalWarning", `--test-timeout=${LIMIT_MS}`],
  ];
  return run(process.execPath, [...args, ...files.map((file) => inRoot("tests", "kits", file))], options);
}
