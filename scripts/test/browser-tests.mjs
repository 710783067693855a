// The scenarios in several browsers, side by side. Where a browser is not to be had, that is said, with the way to get it.

import { inRoot } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";
import { findChromium } from "../setup/chromium.mjs";
import { findFirefox, firefoxRemedy } from "../setup/firefox.mjs";
import { findWebKit, webKitRemedy } from "../setup/webkit.mjs";

const browsers = [
  { name: "Chromium", file: "chromium", found: findChromium, remedy: "apt-get install chromium   (as root)" },
  { name: "Firefox", file: "firefox", found: findFirefox, remedy: firefoxRemedy },
  { name: "WebKit", file: "webkit", found: findWebKit, remedy: webKitRemedy },
];

/** Ends a browser that hangs. */
const LIMIT_MS = 600_000;

/** Resolves to the exit code. */
export async function browserTests(options = {}) {
  const missing = browsers.filter(({ found }) => found() === null);
  const files = browsers.filter((browser) => !missing.includes(browser)).map(({ file }) => `${file}.test.ts`);
  const args = [
    ...["--import", "tsx", "--test", "--test-reporter=spec", "--test-force-exit"],
    ...["--disable-warning=ExperimentalWarning", `--test-timeout=${LIMIT_MS}`, `--test-concurrency=${browsers.length}`],
  ];
  const paths = files.map((file) => inRoot("tests", "browsers", file));
  const code = await run(process.execPath, [...args, ...paths], options);
  const say = options.output ?? ((text) => process.stdout.write(text));
  for (const { name, remedy } of missing) say(`Not run in ${name}, which is not on this machine: ${remedy}\n`);
  return code;
}
