// A Chromium for the page's tests: the machine's own. Nothing is downloaded from a browser vendor.
import { which } from "../lib/environment.mjs";
import { aptInstall } from "./debian.mjs";
import { SetupError, say } from "./report.mjs";

const names = [
  "chromium",
  "chromium-browser",
  "google-chrome-stable",
  "google-chrome",
  "chrome",
  "microsoft-edge",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
];

/** The same engine without windows, tabs and menus of its own: a page opens in half the time. */
const SHELL = "chromium-headless-shell";

export function findChromium() {
  return chosen() ?? names.map(which).find((path) => path !== null) ?? null;
}

/** What pages are opened in where nobody looks on. */
export function findHeadlessChromium() {
  return chosen() ?? which(SHELL) ?? findChromium();
}

function chosen() {
  const path = process.env.CHROME_PATH;
  if (!path) return null;
  if (which(path) === null) throw new SetupError(`CHROME_PATH is ${path}, which is no program.`, "unset CHROME_PATH");
  return which(path);
}

export async function ensureChromium() {
  const found = findChromium();
  if (found !== null) return say("Chromium", found);
  say("Chromium", "installing the Debian package");
  if (!(await aptInstall("chromium")) || findChromium() === null) {
    throw new SetupError(
      "No Chromium was found for the page's tests, and it could not be installed.",
      "apt-get install chromium   (as root), or set CHROME_PATH to a Chromium or Chrome",
    );
  }
}

/** Where it is not to be had, the tests of the page take longer and are the same. */
export async function ensureHeadlessChromium() {
  if (process.env.CHROME_PATH || which(SHELL) !== null) return say("Chromium without windows", findHeadlessChromium());
  say("Chromium without windows", "installing the Debian package");
  await aptInstall(SHELL);
  if (which(SHELL) === null)
    say("Chromium without windows", `could not be installed: ${findChromium()} takes its place`);
}
