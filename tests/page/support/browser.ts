// A Chromium for a test file, and pages in it that complain about every error the console shows.
import assert from "node:assert/strict";
import { after } from "node:test";
import { type Browser, type BrowserContextOptions, chromium, type Page } from "playwright-core";
import { findChromium } from "../../../scripts/setup/chromium.mjs";
import { address } from "./site.js";

let running: Promise<Browser> | undefined;

function browser(): Promise<Browser> {
  const executablePath = findChromium();
  assert(executablePath, "no Chromium was found");
  running ??= chromium.launch({
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
  return running;
}

after(async () => (await running)?.close());

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
