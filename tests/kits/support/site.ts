// Pages of the author kits, built into a folder of their own and served with the built page beside them.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import type { Page } from "playwright-core";
import { childEnvironment } from "../../../scripts/lib/environment.mjs";
import { dist, inRoot } from "../../../scripts/lib/paths.mjs";
import { serve } from "../../../scripts/lib/static-server.mjs";
import { venvPython } from "../../../scripts/setup/python-packages.mjs";

/** Browsers ask for a picture of the site that no kit has. */
export const kit = { before: (page: Page) => page.route("**/favicon.ico", (route) => route.fulfill({ status: 204 })) };

export const onePixel = Buffer.from(
  "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg==",
  "base64",
);

/** Waits until a playground has its answer. */
export const ready = (page: Page, more = "", id = "#lab") =>
  page.waitForSelector(`${id}:is([data-status=optimal], [data-status=solved])${more}`);

/** A copy of a kit's folder, gone after the tests. */
export function copyOf(kit: string): string {
  const folder = mkdtempSync(join(tmpdir(), `mo-copp-${kit}-`));
  after(() => rmSync(folder, { recursive: true, force: true }));
  cpSync(inRoot("kits", kit), folder, { recursive: true });
  return folder;
}

/** Puts the built page into a folder of the kit, as its README says. */
export const addPage = (folder: string) => cpSync(dist, folder, { recursive: true });

export async function served(folder: string): Promise<string> {
  const { server, address } = await serve(folder, { base: "/site/" });
  after(() => {
    server.close();
    server.closeAllConnections();
  });
  return address;
}

/** Runs a program of the project's Python environment; what it printed comes back. */
export function python(args: string[], cwd: string, input = ""): string {
  const run = spawnSync(venvPython, args, { cwd, env: childEnvironment(), encoding: "utf8", timeout: 240_000, input });
  assert.equal(run.status, 0, run.stdout + run.stderr);
  return run.stdout;
}

/** The element's attributes, as the tables of the guide list them. */
export function attributes(): string[] {
  const guide = readFileSync(inRoot("docs", "embedding.md"), "utf8");
  const [tables = ""] = guide.split("## What the page's prose can do", 1);
  return [...tables.matchAll(/^\| ((?:`[a-z-]+`(?:, )?)+) \|/gm)].flatMap(([, names = ""]) =>
    [...names.matchAll(/`([a-z-]+)`/g)].map(([, name = ""]) => name),
  );
}
