// Barriers that axe finds, up to WCAG 2.2 AA, and what it holds for good practice.
import assert from "node:assert/strict";
import { AxeBuilder } from "@axe-core/playwright";
import type { Page } from "playwright-core";

const tags = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

export async function assertNoBarrier(page: Page, state: string): Promise<void> {
  const { violations, passes } = await new AxeBuilder({ page })
    // One run in the page itself: what is not a frame of another site needs no more, and it takes a quarter of the time.
    .setLegacyMode(true)
    .options({ resultTypes: ["violations"] })
    .withTags(tags)
    .analyze();
  assert.deepEqual(
    violations.map(({ id, nodes }) => [id, nodes.map(({ html, failureSummary }) => `${html} ${failureSummary}`)]),
    [],
    state,
  );
  assert(
    passes.some(({ id }) => id === "target-size"),
    "the rules of WCAG 2.2 were looked at",
  );
}
