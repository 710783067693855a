// The page's tests: files run side by side, and share one Chromium, in which each test has a context of its own.
import { readdirSync } from "node:fs";
import { availableParallelism } from "node:os";
import { inRoot } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";

/** A page's test waits for what it expects, for at most a minute; this ends a file that hangs all the same. */
const LIMIT_MS = 600_000;

/** Each file begins with half a second of loading in which the browser has nothing to do. */
const SIDE_BY_SIDE = Math.min(4, availableParallelism() + 1);

/** Runs all of them, or the named files of tests/page/; resolves to the exit code. */
export async function pageTests(options = {}, names = all()) {
  // Known only once the npm packages are there.
  const { launchChromium } = await import("./chromium-server.mjs");
  const server = await launchChromium();
  const args = [
    "--import",
    "tsx",
    "--test",
    "--test-reporter=spec",
    "--test-force-exit",
    "--disable-warning=ExperimentalWarning",
    `--test-timeout=${LIMIT_MS}`,
    `--test-concurrency=${SIDE_BY_SIDE}`,
  ];
  try {
    const files = names.map((name) => inRoot("tests", "page", name));
    return await run(process.execPath, [...args, ...files], {
      ...options,
      env: { MO_COPP_CHROMIUM: server.wsEndpoint() },
    });
  } finally {
    await server.close();
  }
}

const all = () =>
  readdirSync(inRoot("tests", "page"))
    .filter((file) => file.endsWith(".test.ts"))
    .sort();
