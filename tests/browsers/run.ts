// Runs the scenarios in one browser.
import { after, test } from "node:test";
import type { Driver } from "./drivers/driver.js";
import { scenarios } from "./scenarios.js";
import { type Site, site } from "./site.js";

export function inBrowser(browser: string, launch: () => Promise<Driver>): void {
  let driver: Promise<Driver> | undefined;
  const sites: Site[] = [];
  for (const { name, run } of scenarios) {
    test(`${browser}: ${name}`, async () => {
      driver ??= launch();
      // A server for each, so that each begins with nothing in the browser's cache.
      const fresh = await site();
      sites.push(fresh);
      await run(await driver, fresh);
    });
  }
  after(async () => {
    await (await driver?.catch(() => undefined))?.close();
    for (const one of sites) one.close();
  });
}
