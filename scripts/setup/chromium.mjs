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

export function findChromium() {
  const chosen = process.env.CHROME_PATH;
  if (chosen) {
    if (which(chosen) === null)
      throw new SetupError(`CHROME_PATH is ${chosen}, which is no program.`, "unset CHROME_PATH");
    return which(chosen);
  }
  return names.map(which).find((path) => path !== null) ?? null;
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
