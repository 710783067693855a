// The way to the exercises: from the home page and the article to the lesson, and from there into the playground.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { exerciseFiles } from "../../scripts/exercises/files.mjs";
import { visit } from "./support/browser.js";
import { address } from "./support/site.js";

const files = exerciseFiles();

test("home page and article lead to the lesson", () =>
  visit(async ({ page }) => {
    await page.getByRole("contentinfo").getByRole("link", { name: "Exercises", exact: true }).click();
    await page.getByRole("heading", { level: 1, name: "A lesson of one hour" }).waitFor();
    await page.goto(`${address}learn/index.html`);
    const onwards = page.locator("main > section").last().getByRole("link");
    assert.equal(await onwards.count(), 1, "the article ends with a link");
    await onwards.click();
    await page.getByRole("heading", { level: 1, name: "A lesson of one hour" }).waitFor();
  }));

test("a click in the lesson opens each exercise in the playground, and its file stands beside it", () =>
  visit(async ({ page }) => {
    assert.equal(files.length, 12);
    for (const [file, text] of files) {
      const name = file.replace(/\.json$/, "");
      await page.goto(`${address}docs/lesson.html`);
      const link = page.getByRole("link", { name: `file of ${name}`, exact: true });
      assert.equal(await link.getAttribute("href"), `../exercises/${file}`);
      const answer = await page.request.get(`${address}exercises/${file}`);
      assert.equal(await answer.text(), text, file);
      await page.getByRole("link", { name, exact: true }).click();
      await page.waitForURL(`${address}index.html?src=exercises/${file}*`);
      const { title, vary } = JSON.parse(text).exercise;
      await page.locator("#exercise-title", { hasText: title }).waitFor();
      if (vary !== undefined) await page.getByRole("button", { name: "Without a name" }).click();
      await page.locator("#exercise-question").waitFor();
    }
  }));

test("what the lesson links to is there in the repository, for readers of the source", () => {
  const docs = new URL("../../docs/", import.meta.url);
  const links = [...readFileSync(new URL("lesson.md", docs), "utf8").matchAll(/\]\(([^)#]+)\)/g)].map(
    ([, to = ""]) => to,
  );
  assert(links.length > files.length, String(links));
  for (const link of links) assert(readFileSync(new URL(link, docs), "utf8").length > 0, link);
});
