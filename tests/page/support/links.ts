// Links: what the address holds, and following one.
import type { Page } from "playwright-core";
import { unpack } from "../../../www/src/share/packed.js";
import { address } from "./site.js";

/** Waits until the address holds a state that `holds` agrees to. */
export async function addressHolds(page: Page, holds: (state: Record<string, unknown>) => boolean): Promise<string> {
  for (;;) {
    const hash = await page.evaluate(() => location.hash);
    // One that is not right is on its way to be replaced.
    const state = await stateIn(hash).catch(() => null);
    if (state !== null && holds(state)) return hash;
    // The next change of the address; whoever waits in vain is ended by the test's limit.
    await page.waitForFunction((before) => location.hash !== before, hash);
  }
}

export const stateIn = async (hash: string) => JSON.parse(await unpack(hash.slice(1)));

/** Opens an address as somebody does who was sent it. */
export async function follow(page: Page, hash: string): Promise<void> {
  await page.goto("about:blank");
  await page.goto(address + hash);
}
