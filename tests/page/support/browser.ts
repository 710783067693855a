// Pages in a Chromium that complain about every error the console shows.
import assert from "node:assert/strict";
import { after } from "node:test";
import { type Browser, type BrowserContextOptions, type BrowserServer, chromium, type Page } from "playwright-core";
import { launchChromium } from "../../../scripts/test/chromium-server.mjs";
import { address } from "./site.js";

/** The Chromium that `npm test` started for all files; a file that runs by itself starts one. */
const shared = process.env.MO_COPP_CHROMIUM;

let own: BrowserServer | undefined;
let running: Promise<Browser> | undefined;

async function connect(): Promise<Browser> {
  if (shared === undefined) own = await launchChromium();
  return chromium.connect(shared ?? own?.wsEndpoint() ?? "");
}

export function browser(): Promise<Browser> {
  running ??= connect();
  return running;
}

after(async () => {
  await (await running)?.close();
  await own?.close();
});

export interface Visit {
  page: Page;
  /** What the console showed as an error, and errors nobody caught. */
  errors: string[];
  /** Every address that was asked for. */
  requests: string[];
}

/** Opens the page, has `use` work with it, and checks that the console stayed free of errors, unless told not to. */
export async function visit(
  use: (visit: Visit) => Promise<void>,
  { before, quiet = true, ...options }: Options = {},
): Promise<void> {
  const lent = await lend(options, before === undefined);
  let clean = false;
  try {
    const { page } = lent;
    const visit: Visit = { page, errors: [], requests: [] };
    page.on("console", (message) => {
      // The file that a page is handed on from has no icon.
      if (message.location().url.endsWith("/favicon.ico")) return;
      if (message.type() === "error" || message.type() === "warning") visit.errors.push(message.text());
    });
    page.on("pageerror", (error) => visit.errors.push(error.message));
    page.on("request", (request) => visit.requests.push(request.url()));
    await before?.(page);
    await page.goto(address);
    await use(visit);
    if (quiet) assert.deepEqual(visit.errors, []);
    clean = true;
  } finally {
    await giveBack(lent, clean);
  }
}

/** A page in a context of its own. A new one costs as much as two visits, so a test that leaves nothing behind hands its page on. */
interface Lent {
  page: Page;
  /** All that a test can have changed is known and can be put back. */
  plain: boolean;
}

let spare: Lent | null = null;

/** What a test that is handed a used page can ask for. */
const changeable = new Set(["colorScheme", "reducedMotion", "viewport"]);
/** What leaves marks on a page or its context that cannot be taken away. */
const marking = {
  page: ["addInitScript", "exposeFunction", "exposeBinding", "routeWebSocket"],
  context: ["addInitScript", "exposeFunction", "exposeBinding", "route", "grantPermissions", "setOffline", "newPage"],
} as const;

/** For what is waited for at most: a machine may do much else meanwhile. */
const PATIENCE_MS = 60_000;

const VIEWPORT = { width: 1280, height: 800 };

async function lend(options: BrowserContextOptions, plain: boolean): Promise<Lent> {
  plain &&= Object.keys(options).every((name) => changeable.has(name));
  const used = plain ? spare : null;
  if (used === null) {
    const context = await (await browser()).newContext({ viewport: VIEWPORT, ...options });
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE_MS);
    const lent: Lent = { page, plain };
    watchForMarks(lent);
    return lent;
  }
  spare = null;
  const { page } = used;
  const { viewport, colorScheme = null, reducedMotion = null } = options;
  await page.setViewportSize(viewport ?? VIEWPORT);
  await page.emulateMedia({ colorScheme, reducedMotion, media: null, forcedColors: null });
  return used;
}

function watchForMarks(lent: Lent): void {
  const { page } = lent;
  const context = page.context();
  const watch = (on: object, name: string) => {
    const own = Reflect.get(on, name);
    Object.defineProperty(on, name, {
      configurable: true,
      get: () => {
        lent.plain = false;
        return own;
      },
    });
  };
  for (const name of [...marking.page, "clock"]) watch(page, name);
  for (const name of [...marking.context, "clock"]) watch(context, name);
}

async function giveBack(lent: Lent, clean: boolean): Promise<void> {
  const { page } = lent;
  if (!clean || !lent.plain || spare !== null || page.isClosed()) return end(page);
  try {
    page.removeAllListeners();
    await page.unrouteAll({ behavior: "ignoreErrors" });
    // From a file beside the page: the page itself may keep something when it is left.
    await page.goto(`${address}THIRD-PARTY.txt`, { timeout: 5000 });
    await page.evaluate(() => {
      localStorage.clear();
      sessionStorage.clear();
    });
    spare = lent;
  } catch {
    await end(page);
  }
}

const end = (page: Page) => page.context().close();

export interface Options extends BrowserContextOptions {
  /** Runs before the page is opened. */
  before?: (page: Page) => Promise<unknown>;
  /** Whether errors on the console fail the test. */
  quiet?: boolean;
}
