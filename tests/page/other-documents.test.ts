// The element in documents other than the one whose script it is, and in one that is still being built.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { address } from "./support/site.js";

async function lesson(page: Page, html: string): Promise<void> {
  await page.route(`${address}lesson/document.html`, (route) =>
    route.fulfill({ contentType: "text/html", body: html }),
  );
  await page.goto(`${address}lesson/document.html`);
}

const script = `<script type="module" src="../mo-copp-playground.js"></script>`;
const one = `<mo-copp-playground id="one" problem="corridor" link="off"></mo-copp-playground>`;

/** What the styles make of the playground, wherever it is. */
const look = (page: Page) =>
  page.evaluate(() => {
    const pages = [document, document.querySelector("iframe")?.contentDocument];
    const found = pages.map((where) => where?.querySelector("#one") ?? null).find((one) => one !== null);
    const parts = [
      ...(found?.shadowRoot?.querySelectorAll(".card, svg[data-board], h2, .stepper, button, table") ?? []),
    ];
    return parts.map((part) => {
      const { backgroundColor, color, fontSize, display, padding } = getComputedStyle(part);
      return [part.getAttribute("class"), backgroundColor, color, fontSize, display, padding].join(" ");
    });
  });

test("a running element that is moved into a frame and back keeps its looks and goes on", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Moved</title>${script}</head>
        <body><div id="here" style="width: 900px">${one}</div><iframe title="There" style="border: 0; width: 900px; height: 1500px"></iframe></body></html>`,
    );
    await page.waitForSelector("#one[data-status=optimal]");
    await page.evaluate(() => {
      const inner = document.querySelector("iframe")?.contentDocument;
      inner?.open();
      inner?.write("<!doctype html><html lang=en><title>There</title><body style='margin: 0'></body></html>");
      inner?.close();
    });
    const before = await look(page);
    assert(before.length > 10, `${before.length} parts are there`);
    await page.evaluate(() => {
      const one = document.querySelector("#one");
      if (one !== null) document.querySelector("iframe")?.contentDocument?.body.append(one);
    });
    assert.deepEqual(await look(page), before);
    const there = page.frameLocator("iframe").locator("#one");
    await there.getByRole("button", { name: "Back one step" }).click();
    await page.frameLocator("iframe").locator('#one[data-step="4"]').waitFor();
    // The theme is that of the document around it now.
    await page.evaluate(() => {
      const inner = document.querySelector("iframe")?.contentDocument;
      if (inner) inner.documentElement.style.colorScheme = "dark";
    });
    await page.frameLocator("iframe").locator("#one[data-scheme=dark]").waitFor();
    await page.evaluate(() => {
      const one = document.querySelector("iframe")?.contentDocument?.querySelector("#one");
      if (one) document.querySelector("#here")?.append(one);
    });
    await page.waitForSelector('#one[data-scheme=light][data-step="4"]');
    await page.locator("#one").getByRole("button", { name: "Forward one step" }).click();
    await page.waitForSelector('#one[data-step="5"]');
    assert.deepEqual(await look(page), before);
  }));

test("an element that is first put into the document of a frame has its looks there", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Made here</title>${script}</head>
        <body><iframe title="There" style="border: 0; width: 900px; height: 1500px"></iframe></body></html>`,
    );
    await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
    await page.evaluate(() => {
      const made = document.createElement("mo-copp-playground");
      for (const [name, value] of Object.entries({ id: "one", problem: "corridor", link: "off" }))
        made.setAttribute(name, value);
      document.querySelector("iframe")?.contentDocument?.body.append(made);
    });
    await page.frameLocator("iframe").locator("#one[data-status=optimal]").waitFor();
    const display = await page
      .frameLocator("iframe")
      .locator("#one .below")
      .evaluate((part) => getComputedStyle(part).display);
    assert.equal(display, "grid");
  }));

test("an element that is there before the page's body follows its theme once there is one", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Built</title>
        <script src="../mo-copp-playground.single.js"></script>
        <script>
          const made = document.createElement("mo-copp-playground");
          for (const [name, value] of Object.entries({ id: "one", problem: "corridor", link: "off" })) made.setAttribute(name, value);
          document.documentElement.append(made);
          window.before = document.body === null;
        </script></head><body><p>Text</p></body></html>`,
    );
    assert.equal(await page.evaluate("before"), true);
    await page.waitForSelector("#one[data-status=optimal][data-scheme=light]");
    // A style sheet in the body, and a switch on the element's way to the root.
    await page.evaluate(() => {
      document.body.insertAdjacentHTML("beforeend", "<style>html { color-scheme: dark }</style>");
    });
    await page.waitForSelector("#one[data-scheme=dark]");
    await page.evaluate(() => document.body.append(document.querySelector("#one") as Element));
    await page.waitForSelector("#one[data-scheme=dark][data-status=optimal]");
    await page.evaluate(() => document.body.setAttribute("data-theme", "light"));
    await page.waitForSelector("#one[data-scheme=light]");
  }));
