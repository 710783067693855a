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
  const context = await (await browser()).newContext({ viewport: { width: 1280, height: 800 }, ...options });
  try {
    const page = await context.newPage();
    const visit: Visit = { page, errors: [], requests: [] };
    page.on("console", (message) => {
      if (message.type() === "error" || message.type() === "warning") visit.errors.push(message.text());
    });
    page.on("pageerror", (error) => visit.errors.push(error.message));
    page.on("request", (request) => visit.requests.push(request.url()));
    await before?.(page);
    await page.goto(address);
    await use(visit);
    if (quiet) assert.deepEqual(visit.errors, []);
  } finally {
    await context.close();
  }
}

export interface Options extends BrowserContextOptions {
  /** Runs before the page is opened. */
  before?: (page: Page) => Promise<unknown>;
  /** Whether errors on the console fail the test. */
  quiet?: boolean;
}
