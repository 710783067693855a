// Copying the link to what is shown.
import assert from "node:assert/strict";
import { randomBytes } from "node:crypto";
import { test } from "node:test";
import { unpack } from "../../www/src/share/packed.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { documentOf } from "./support/gallery.js";
import { press, statusIs, useDocument } from "./support/playground.js";
import { address } from "./support/site.js";

test("the link is copied, and the page says so", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await press(page, "Copy link");
      await page.getByRole("button", { name: "Copied" }).waitFor();
      await page.getByText("The link is on the clipboard.").waitFor({ state: "attached" });
      const link = await page.evaluate(() => navigator.clipboard.readText());
      assert(link.startsWith(`${address}#1.`), link);
      assert.equal(JSON.parse(await unpack(new URL(link).hash.slice(1))).document, documentOf("eight-by-eight"));
      await page.getByRole("button", { name: "Copy link" }).waitFor();
    },
    { permissions: ["clipboard-read", "clipboard-write"] },
  ));

test("where the page may not use the clipboard, the link is there to be copied by hand", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await press(page, "Copy link");
      const field = page.getByLabel("copy the link from here");
      await field.waitFor();
      assert.match(await field.inputValue(), /#1\./);
      await field.focus();
      assert(await field.evaluate((input: HTMLInputElement) => input.selectionEnd === input.value.length));
      await press(page, "Done");
      await field.waitFor({ state: "hidden" });
    },
    {
      before: (page) =>
        page.addInitScript(`
          navigator.clipboard.writeText = () => Promise.reject(new DOMException("no", "NotAllowedError"));
          document.execCommand = () => false;
        `),
    },
  ));

test("a problem that is too large for a link has none, and the page says what to do", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    // Names that nothing can make shorter.
    const name = () => randomBytes(1000).toString("base64url");
    const goals = Array.from({ length: 60 }, () => ({ name: name(), cell: [3, 0] }));
    await useDocument(page, grid({ goals, true_goal: goals[0]?.name, walls: [] }));
    await page.waitForFunction(() => document.querySelectorAll("tr[data-goal]").length === 60);
    await press(page, "Copy link");
    await page.getByText("too large for a link").waitFor();
    await page.waitForFunction(() => location.hash === "");
  }));
