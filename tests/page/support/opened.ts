// The page, opened and brought to where a test begins: its first problem is solved, another is used, a tab is open.
import type { Page } from "playwright-core";
import { type Options, visit } from "./browser.js";
import { openTab, press, statusIs, useDocument } from "./playground.js";

export interface Opening extends Options {
  /** Used in place of the page's first problem. */
  document?: string;
  /** Its search, which takes long, is stopped once there is a plan. */
  stopped?: true;
  tab?: string;
}

export const opened = (
  { document, stopped, tab, ...options }: Opening,
  use: (page: Page) => Promise<void>,
): Promise<void> =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    if (document !== undefined) await useDocument(page, document);
    if (stopped) {
      await openTab(page, "Solve");
      await page.getByText(/best so far/).waitFor();
      await press(page, "Cancel");
      await statusIs(page, "feasible");
    }
    if (tab !== undefined) await openTab(page, tab);
    await use(page);
  }, options);

/** Makes a document of the problem by an edit, as the page's own controls do. */
export const edit = (page: Page, document: string): Promise<unknown> =>
  page.evaluate(
    `document.querySelector("mo-copp-playground")[Symbol.for("mo-copp view")].playground.edits.apply(${document})`,
  );
