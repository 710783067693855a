// A Firefox for the tests in several browsers: the machine's own.
import { which } from "../lib/environment.mjs";
import { aptInstall } from "./debian.mjs";
import { say } from "./report.mjs";

const names = ["firefox-esr", "firefox", "/Applications/Firefox.app/Contents/MacOS/firefox"];

/** How to get one where set-up could not. */
export const firefoxRemedy = "apt-get install firefox-esr   (as root), or any Firefox on PATH, or FIREFOX_PATH";

export const findFirefox = () =>
  [process.env.FIREFOX_PATH, ...names]
    .filter(Boolean)
    .map(which)
    .find((path) => path !== null) ?? null;

export async function ensureFirefox() {
  if (findFirefox() === null) {
    say("Firefox", "installing the Debian package");
    await aptInstall("firefox-esr");
  }
  say("Firefox", findFirefox() ?? `could not be installed: its tests are left out (${firefoxRemedy})`);
}
