// WebKit, the engine of Safari, as WebKitGTK's MiniBrowser, driven by Selenium over WebDriver.
import { type ChildProcess, spawn } from "node:child_process";
import { createServer } from "node:net";
import { Builder, Capabilities, error, Key as Keys, Origin, type WebDriver, type WebElement } from "selenium-webdriver";
import { findWebKit } from "../../../scripts/setup/webkit.mjs";
import { type Driver, inPage, type Key, missing, SIZE } from "./driver.js";

/** How long an element may take until it stands still. */
const STEADY_MS = 5_000;

const keys: Record<Key, string> = {
  ArrowLeft: Keys.ARROW_LEFT,
  ArrowRight: Keys.ARROW_RIGHT,
  Home: Keys.HOME,
  End: Keys.END,
  Enter: Keys.ENTER,
};

export async function launch(): Promise<Driver> {
  const found = findWebKit();
  if (found === null) throw new Error("no WebKit was found: npm run setup");
  const started: ChildProcess[] = [];
  const end = () => {
    for (const child of started.reverse()) child.kill();
  };
  try {
    const display = process.env.DISPLAY ?? (await startDisplay(found.xvfb, started));
    const port = await freePort();
    const environment = { ...process.env, DISPLAY: display, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1" };
    started.push(spawn(found.driver, [`--port=${port}`], { env: environment, stdio: "ignore" }));
    const driver = await connect(port, found.browser);
    return { ...actions(driver), close: () => driver.quit().finally(end) };
  } catch (error) {
    end();
    throw error;
  }
}

/** A screen in memory; it says which number it took. */
function startDisplay(program: string, started: ChildProcess[]): Promise<string> {
  const screen = spawn(program, ["-displayfd", "3", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  started.push(screen);
  return new Promise((resolve, reject) => {
    screen.once("exit", () => reject(new Error("Xvfb did not start")));
    screen.stdio[3]?.once("data", (number: Buffer) => resolve(`:${number.toString().trim()}`));
  });
}

function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const server = createServer();
    server.once("error", reject);
    server.listen(0, "127.0.0.1", () => {
      const address = server.address();
      server.close(() => (typeof address === "object" && address !== null ? resolve(address.port) : reject()));
    });
  });
}

async function connect(port: number, binary: string): Promise<WebDriver> {
  const capabilities = new Capabilities({
    browserName: "MiniBrowser",
    "webkitgtk:browserOptions": { binary, args: ["--automation"] },
    timeouts: { script: 120_000 },
  });
  // The driver says nowhere that it listens by now.
  for (let tries = 0; ; tries += 1) {
    try {
      const built = new Builder().usingServer(`http://127.0.0.1:${port}`).withCapabilities(capabilities);
      const driver = await built.build();
      await driver.manage().setTimeouts({ script: 120_000 });
      await driver
        .manage()
        .window()
        .setRect({ x: 0, y: 0, width: SIZE.width, height: SIZE.height + 100 });
      return driver;
    } catch (error) {
      if (tries === 100 || !/ECONNREFUSED/.test(String(error))) throw error;
      await new Promise((done) => setTimeout(done, 100));
    }
  }
}

function actions(driver: WebDriver): Omit<Driver, "close"> {
  const element = async (find: string) => {
    const found = await driver.executeScript<WebElement | null>(`return ${inPage(find)}`);
    if (found === null) throw missing(find);
    return found;
  };
  // A picture that is drawn anew meanwhile takes its element away, or moves it: it is looked for again, for a while.
  const steady = async (act: () => Promise<void>) => {
    for (const begun = performance.now(); ; ) {
      try {
        return await act();
      } catch (failed) {
        const moved =
          failed instanceof error.StaleElementReferenceError || failed instanceof error.ElementNotInteractableError;
        if (!moved || performance.now() - begun > STEADY_MS) throw failed;
        await new Promise((done) => setTimeout(done, 50));
      }
    }
  };
  return {
    open: (address) => driver.get(address),
    evaluate: async <T>(expression: string) => {
      const answer: { value?: T; error?: string } = await driver.executeAsyncScript(`
        const done = arguments[arguments.length - 1];
        Promise.resolve().then(() => ${inPage(expression)}).then(
          (value) => done({ value }),
          (error) => done({ error: String(error) }),
        );`);
      if (answer.error !== undefined) throw new Error(answer.error);
      return answer.value as T;
    },
    click: (find) => steady(async () => (await element(find)).click()),
    type: (find, text) =>
      steady(async () => {
        const field = await element(find);
        await field.clear();
        await field.sendKeys(text);
      }),
    press: (find, key) => steady(async () => (await element(find)).sendKeys(keys[key])),
    drag: async (from, to) => {
      const hand = driver.actions({ async: true });
      await hand
        .move({ origin: await element(from), duration: 50 })
        .press()
        .move({ origin: await element(to), duration: 200 })
        .move({ origin: Origin.POINTER, x: 1, y: 1, duration: 50 })
        .release()
        .perform();
    },
  };
}
