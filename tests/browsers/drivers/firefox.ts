// Firefox, driven by Puppeteer over WebDriver BiDi.
import puppeteer, { type ElementHandle } from "puppeteer-core";
import { findFirefox } from "../../../scripts/setup/firefox.mjs";
import { type Driver, inPage, missing, SIZE } from "./driver.js";

export async function launch(): Promise<Driver> {
  const executablePath = findFirefox();
  if (executablePath === null) throw new Error("no Firefox was found: npm run setup");
  const browser = await puppeteer.launch({
    browser: "firefox",
    executablePath,
    headless: true,
    defaultViewport: SIZE,
    timeout: 120_000,
    protocolTimeout: 180_000,
  });
  const page = await browser.newPage();
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
    evaluate: async <T>(expression: string) => (await page.evaluate(inPage(expression))) as T,
    click: async (find) => (await element(find)).click(),
    type: async (find, text) => {
      const field = await element(find);
      await field.click({ count: 3 });
      await field.type(text);
    },
    press: async (find, key) => (await element(find)).press(key),
    drag: async (from, to) => {
      await (await element(from)).scrollIntoView();
      const [begin, end] = [await middle(from), await middle(to)];
      await page.mouse.move(...begin);
      await page.mouse.down();
      await page.mouse.move(...end, { steps: 4 });
      await page.mouse.up();
    },
    close: () => browser.close(),
  };
}
