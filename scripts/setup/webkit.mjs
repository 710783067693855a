// WebKit, the engine of Safari, for the tests in several browsers: WebKitGTK's browser and driver, and a screen in memory.
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { which } from "../lib/environment.mjs";
import { aptInstall } from "./debian.mjs";
import { say } from "./report.mjs";

/** How to get it where set-up could not. */
export const webKitRemedy = "apt-get install webkit2gtk-driver xvfb   (as root, Debian or Ubuntu)";

/** Where distributions put what is no command by itself. */
const folders = ["/usr/lib", "/usr/lib64", "/usr/libexec"];

function miniBrowser() {
  const inside = (folder) => (existsSync(folder) ? readdirSync(folder).map((name) => join(folder, name)) : []);
  const places = folders.flatMap((folder) => [...inside(folder), ...inside(folder).flatMap(ofTriplet)]);
  return places.map((folder) => join(folder, "MiniBrowser")).find((path) => existsSync(path)) ?? null;
}

/** Debian has a folder for each kind of processor between them. */
const ofTriplet = (folder) =>
  /-linux-gnu[^/]*$/.test(folder) ? readdirSync(folder).map((name) => join(folder, name)) : [];

/** The programs, or null where one is missing. */
export function findWebKit() {
  const [driver, browser, xvfb] = [which("WebKitWebDriver"), miniBrowser(), which("Xvfb")];
  return driver === null || browser === null || xvfb === null ? null : { driver, browser, xvfb };
}

export async function ensureWebKit() {
  if (findWebKit() === null) {
    say("WebKit", "installing the Debian packages");
    await aptInstall("webkit2gtk-driver", "xvfb");
  }
  say("WebKit", findWebKit()?.driver ?? `could not be installed: its tests are left out (${webKitRemedy})`);
}
