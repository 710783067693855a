// Chromium, driven by Playwright.
import { type BrowserServer, chromium, type ElementHandle } from "playwright-core";
import { launchChromium } from "../../../scripts/test/chromium-server.mjs";
import { type Driver, inPage, missing, SIZE } from "./driver.js";

export async function launch(): Promise<Driver> {
  // The one that `npm test` has for the page's tests, or one of its own.
  const shared = process.env.MO_COPP_CHROMIUM;
  const own: BrowserServer | null = shared === undefined ? await launchChromium() : null;
  const browser = await chromium.connect(own?.wsEndpoint() ?? shared ?? "");
  const page = await (await browser.newContext({ viewport: SIZE })).newPage();
  page.setDefaultTimeout(60_000);
  const element = async (find: string) => {
    const found = (await page.evaluateHandle(inPage(find))).asElement() as ElementHandle<Element> | null;
    if (found === null) throw missing(find);
    return found;
  };
  const middle = async (find: string) => {
    const box = await (await element(find)).boundingBox();
    if (box === null) throw missing(find);
    return [box.x + box.width / 2, box.y + box.height / 2] as const;
  };
  return {
    open: async (address) => void (await page.goto(address)),
    evaluate: (expression) => page.evaluate(inPage(expression)),
    click: async (find) => (await element(find)).click(),
    type: async (find, text) => (await element(find)).fill(text),
    press: async (find, key) => (await element(find)).press(key),
    drag: async (from, to) => {
      await (await element(from)).scrollIntoViewIfNeeded();
      const [begin, end] = [await middle(from), await middle(to)];
      await page.mouse.move(...begin);
      await page.mouse.down();
      await page.mouse.move(...end, { steps: 4 });
      await page.mouse.up();
    },
    close: async () => {
      await browser.close();
      await own?.close();
    },
  };
}
