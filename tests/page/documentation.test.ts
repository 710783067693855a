// The documents as pages of the site: reached from the footer, with their pictures, readable at every width.
import assert from "node:assert/strict";
import { test } from "node:test";
import { pages } from "../../scripts/documentation/render.mjs";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { address } from "./support/site.js";

test("the footer leads to the documents, and each to all others", () =>
  visit(async ({ page }) => {
    await page.getByRole("contentinfo").getByRole("link", { name: "Problem documents and the command" }).click();
    await page.getByRole("heading", { level: 1, name: "Problem documents and output" }).waitFor();
    for (const [name, label] of pages) {
      await page.getByRole("navigation").getByRole("link", { name: label }).click();
      await page.waitForURL(`${address}docs/${name}.html`);
      const current = page.getByRole("navigation").locator("[aria-current=page]");
      assert.equal(await current.textContent(), label);
    }
    await page.getByRole("navigation").getByRole("link", { name: "Playground" }).click();
    await page.waitForSelector("mo-copp-playground[data-status=optimal]");
  }));

test("links between documents and within them lead somewhere", () =>
  visit(async ({ page, requests }) => {
    for (const [name] of pages) {
      await page.goto(`${address}docs/${name}.html`);
      const links = await page
        .locator("main a")
        .evaluateAll((found) => found.map((link) => (link as HTMLAnchorElement).href));
      for (const link of links.filter((link) => link.startsWith(address))) {
        const [file = "", hash] = link.split("#");
        const answer = await page.request.get(file);
        assert.equal(answer.status(), 200, `${name}: ${link}`);
        if (hash) assert.match(await answer.text(), new RegExp(`id="${hash}"`), `${name}: ${link}`);
      }
    }
    assert.deepEqual(
      requests.filter((request) => !request.startsWith(address)),
      [],
    );
  }));

for (const width of [1280, 320]) {
  test(`documents can be read by everyone, ${width} px, light and dark`, () =>
    visit(
      async ({ page }) => {
        for (const [name] of pages) {
          await page.goto(`${address}docs/${name}.html`);
          const broken = await page
            .locator("img")
            .evaluateAll((images) => images.filter((image) => (image as HTMLImageElement).naturalWidth === 0).length);
          assert.equal(broken, 0, `${name} has pictures that do not show`);
          const wide = await page.evaluate("document.documentElement.scrollWidth - innerWidth");
          assert.ok(Number(wide) <= 0, `${name} is ${wide} px too wide`);
          await assertNoBarrier(page, name, { dark: true });
        }
      },
      { viewport: { width, height: 800 } },
    ));
}

test("on a phone what tables say of keys has more room than the keys", () =>
  visit(
    async ({ page }) => {
      for (const [name] of pages) {
        await page.goto(`${address}docs/${name}.html`);
        const narrow = await page.locator("table").evaluateAll((tables) =>
          tables.flatMap((table) => {
            const cells = [...(table as HTMLTableElement).rows].at(-1)?.cells ?? [];
            const [key, words] = [...cells].map((cell) => cell.getBoundingClientRect().width);
            const ofKeys = cells.length === 2 && cells[0]?.querySelector("code") !== null;
            return ofKeys && Number(words) < Number(key) ? [`${cells[0]?.textContent}: ${key}, ${words}`] : [];
          }),
        );
        assert.deepEqual(narrow, [], name);
      }
    },
    { viewport: { width: 390, height: 800 } },
  ));
