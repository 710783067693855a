// The Chromium of the page's tests, as a server that several processes can use.
import { chromium } from "playwright-core";
import { findHeadlessChromium } from "../setup/chromium.mjs";

export function launchChromium() {
  const executablePath = findHeadlessChromium();
  if (executablePath === null) throw new Error("no Chromium was found: npm run setup");
  return chromium.launchServer({
    executablePath,
    args: [
      // Neither root nor every container has a sandbox; the only page that is opened is our own.
      "--no-sandbox",
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
    ],
  });
}
