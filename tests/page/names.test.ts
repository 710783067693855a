// Names that could look alike, like nothing, or turn the text around them.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { nameFault } from "../../www/src/problem/names.js";
import { unseenIn, visible } from "../../www/src/problem/unseen.js";
import { named } from "../../www/src/view/names.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { openTab, statusIs, useDocument } from "./support/playground.js";

test("what can't be seen in a name is written as its number, what belongs to a letter is not", () => {
  assert.equal(visible("G\u200b1"), "G⟨U+200B⟩1");
  assert.equal(visible("\u2060\ufeff"), "⟨U+2060⟩⟨U+FEFF⟩");
  assert.equal(visible("a\u202eb"), "a⟨U+202E⟩b");
  assert.equal(visible("a\u0000\u0007\u2028"), "a⟨U+0000⟩⟨U+0007⟩⟨U+2028⟩");
  assert.equal(visible("G1\ufe0f"), "G1⟨U+FE0F⟩");
  assert.equal(visible("\u{e0041}"), "⟨U+E0041⟩");
  for (const fine of ["G1", "north-east", "é", "Ελλάς", "目標", "👩‍🚀", "❤️", "1️⃣", "क्‍ष", "می‌خواهم", "יעד"]) {
    assert.equal(visible(fine), fine);
    assert.deepEqual(unseenIn(fine), []);
    assert.equal(nameFault(fine, []), null);
  }
  assert.match(nameFault("G\u200b1", []) ?? "", /U\+200B, which can’t be seen/);
  assert.equal(named("north"), "north");
  assert.equal(named("יעד 1"), "\u2068יעד 1\u2069");
});

const goals = (one: string) => [
  { name: one, cell: [3, 0] },
  { name: "G2", cell: [0, 0] },
];

test("names from the right keep the text around them in its order", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const name = "יעד 1";
    await useDocument(page, grid({ goals: goals(name), true_goal: name }));
    await page.locator(`.survivors [data-goal="${name}"]`).first().waitFor();
    await statusIs(page, "optimal");
    await page.locator(".goals .choose", { hasText: name }).click();
    await page.locator(".story", { hasText: `\u2068${name}\u2069: ` }).waitFor();
    const isolated = (selector: string) =>
      page
        .locator(selector, { hasText: name })
        .first()
        .evaluate((part) => getComputedStyle(part).unicodeBidi);
    for (const selector of [".survivors .name", ".goals .name"]) assert.equal(await isolated(selector), "plaintext");
  }));

/** A document with such a name is refused, or each such sign is seen. */
async function refusedOrSeen(page: Page, text: string, sign: string): Promise<void> {
  await useDocument(page, text);
  await page.waitForFunction((sign) => {
    const refused = document.querySelector("mo-copp-playground")?.getAttribute("data-status") === "error";
    return refused || document.querySelector(".survivors")?.textContent?.includes(sign);
  }, sign);
}

test("a document whose names can't be told apart is refused, or their signs are seen", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    for (const [name, sign] of [
      ["\u200b\u200b", "⟨U+200B⟩⟨U+200B⟩"],
      ["G2\u200b", "G2⟨U+200B⟩"],
      ["\u202e1G", "⟨U+202E⟩1G"],
    ] as const) {
      await refusedOrSeen(page, grid({ goals: goals(name), true_goal: name }), sign);
    }
  }));

test("a goal is not renamed to what can't be seen", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openTab(page, "Edit");
    const field = page.getByLabel("Name of goal 1");
    await field.fill("G\u200b2");
    await field.press("Enter");
    await page.getByText("“G⟨U+200B⟩2” holds U+200B, which can’t be seen: take it out.").waitFor();
  }));
