// Barriers that axe finds, up to WCAG 2.2 AA, and what it holds for good practice.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { AxeResults, RunOptions } from "axe-core";
import type { Page } from "playwright-core";

const source = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const tags = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];
/** The rules whose outcome hangs on colours; all others say the same in light and dark. */
const colours = ["color-contrast", "link-in-text-block"];

interface Look {
  /** A selector, where not the whole page is looked at. */
  within?: string;
  /** Looks at the colours of the dark scheme as well. */
  dark?: boolean;
}

/** The page as it is, by all rules. */
export async function assertNoBarrier(page: Page, state: string, { within, dark = false }: Look = {}): Promise<void> {
  const { violations, passes } = await look(page, within, { type: "tag", values: tags });
  assertNone(violations, state);
  assert(
    passes.some(({ id }) => id === "target-size"),
    "the rules of WCAG 2.2 were looked at",
  );
  if (!dark) return;
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  assert.equal(await page.evaluate(() => matchMedia("(prefers-color-scheme: dark)").matches), true);
  // Scripts are told in the next frame.
  await page.evaluate(() => new Promise((told) => requestAnimationFrame(() => requestAnimationFrame(told))));
  const inDark = await look(page, within, { type: "rule", values: colours });
  assertNone(inDark.violations, `${state}, dark`);
  assert(
    inDark.passes.some(({ id }) => id === "color-contrast"),
    "contrasts were looked at",
  );
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
}

function assertNone(violations: AxeResults["violations"], state: string): void {
  const found = violations.map(({ id, nodes }) => [
    id,
    nodes.map(({ html, failureSummary }) => `${html} ${failureSummary}`),
  ]);
  assert.deepEqual(found, [], state);
}

/** One run in the page itself, which holds axe from its first run on. */
async function look(page: Page, within: string | undefined, runOnly: RunOptions["runOnly"]): Promise<AxeResults> {
  if (!(await page.evaluate("'axe' in window"))) await page.evaluate(source);
  const options = { runOnly, resultTypes: ["violations"] };
  return page.evaluate(`axe.run(${JSON.stringify(within ?? null)} ?? document, ${JSON.stringify(options)})`);
}
