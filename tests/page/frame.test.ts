// What a frame and the page around it say to each other.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { address } from "./support/site.js";

const guide = readFileSync(new URL("../../docs/frames.md", import.meta.url), "utf8");
const listenerOfGuide =
  /```js\n(addEventListener[\s\S]*?)```/.exec(guide)?.[1] ?? assert.fail("no listener in the guide");

interface Message {
  type?: string;
  subject?: string;
  event?: string;
  version?: number;
  height?: number;
  score?: number | null;
  state?: { document: string; step: number };
  message_id?: string;
  detail?: { step?: number; status?: string };
}

/** A page around a frame. As course systems do at a first visit, it answers with an empty state. */
async function around(page: Page, host = address): Promise<void> {
  await page.route(`${host}lesson/frame.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><html lang="en"><title>Around</title>
        <script>
          window.heard = [];
          addEventListener("message", ({ source, data }) => {
            window.heard.push(data);
            const { subject, message_id } = data;
            if (subject === "SPLICE.getState") source.postMessage({ subject: subject + ".response", message_id, state: {} }, "*");
          });
        </script>
        <iframe src="../index.html?problem=corridor&amp;hide=intro,footer,workbench" title="Frame" width="900" height="300"></iframe>`,
    }),
  );
  await page.goto(`${host}lesson/frame.html`);
}

const heard = (page: Page) => page.evaluate(() => (window as unknown as { heard: Message[] }).heard);
const says = (page: Page, wanted: Partial<Message>) =>
  page.waitForFunction(
    (wanted) =>
      (window as unknown as { heard: Message[] }).heard.some((message) =>
        Object.entries(wanted).every(([name, value]) => message[name as keyof Message] === value),
      ),
    wanted,
  );
const say = (page: Page, message: unknown) =>
  page.evaluate((message) => document.querySelector("iframe")?.contentWindow?.postMessage(message, "*"), message);
const ours = { type: "mo-copp", version: 1 };

test("a frame tells its height, steps, outcomes and state, and takes steps, themes, documents and states", () =>
  visit(async ({ page }) => {
    await around(page);
    const frame = page.frameLocator("iframe").locator("mo-copp-playground");
    await says(page, { ...ours, event: "ready" });
    await says(page, { ...ours, event: "outcome" });
    await says(page, { subject: "lti.frameResize" });
    await says(page, { subject: "SPLICE.getState" });
    await says(page, { ...ours, event: "state" });
    const told = await heard(page);
    const height = told.filter(({ subject }) => subject === "lti.frameResize").at(-1)?.height ?? 0;
    assert(height > 300 && height < 3000, `${height}`);
    await say(page, { ...ours, command: "step", step: 2 });
    await frame.and(page.frameLocator("iframe").locator('[data-step="2"]')).waitFor();
    await say(page, { ...ours, command: "theme", theme: "dark" });
    await page.frameLocator("iframe").locator('body[data-scheme="dark"]').waitFor();
    const kept = (await heard(page)).filter(({ event }) => event === "state").at(-1)?.state;
    await say(page, { ...ours, command: "document", document: JSON.parse(grid({ width: 6 })) });
    await page.frameLocator("iframe").locator('[data-board=actor] [data-cell="5,0"]').waitFor({ state: "attached" });
    await say(page, { subject: "SPLICE.getState.response", state: kept });
    await page.frameLocator("iframe").locator(".title", { hasText: "One step too far" }).waitFor();
  }));

test("a frame that is as high as it tells has nothing to scroll, whatever is hidden", () =>
  visit(async ({ page }) => {
    for (const hidden of [
      "intro,footer",
      "intro,workbench,footer",
      "intro,workbench",
      "",
      "intro,footer,workbench,goals,legend,stepper",
    ]) {
      // The listener is the guide's.
      await page.route(`${address}lesson/high.html`, (route) =>
        route.fulfill({
          contentType: "text/html",
          body: `<!doctype html><html lang="en"><title>High</title><script>${listenerOfGuide}</script>
            <iframe src="../index.html?problem=delivery&hide=${hidden}" title="Frame" width="900"></iframe>`,
        }),
      );
      await page.goto(`${address}lesson/high.html`);
      await page.frameLocator("iframe").locator("mo-copp-playground[data-status=optimal]").waitFor();
      await page.waitForFunction(() => {
        const inner = document.querySelector("iframe")?.contentWindow;
        const root = inner?.document.documentElement;
        return root !== undefined && root.scrollHeight === inner?.innerHeight && root.clientWidth === inner.innerWidth;
      });
      await page.unroute(`${address}lesson/high.html`);
    }
  }));

test("what has another shape, another version or another sender is ignored", () =>
  visit(async ({ page }) => {
    await around(page);
    const frame = page.frameLocator("iframe");
    await frame.locator('mo-copp-playground[data-status="optimal"]').waitFor();
    await say(page, { ...ours, command: "step", step: 5 });
    await frame.locator('mo-copp-playground[data-step="5"]').waitFor();
    const state = { document: grid(), step: 1 };
    for (const message of [
      "step",
      null,
      [1, 2],
      { ...ours, version: 2, command: "step", step: 1 },
      { ...ours, command: "step", step: -1 },
      { ...ours, command: "step", step: "1" },
      { ...ours, command: "theme", theme: "url(x)" },
      { ...ours, command: "document", document: 3 },
      { ...ours, command: "document", document: {} },
      { ...ours, command: "document", document: "hello" },
      { ...ours, command: "document", document: grid() + " ".repeat(2_000_000) },
      { ...ours, command: "state", state: {} },
      { ...ours, command: "state", state: { document: "hello", step: 1 } },
      { ...ours, command: "run", code: "alert(1)" },
      { subject: "SPLICE.getState.response", state: "text" },
      { subject: "SPLICE.getState.response", state: { score: 1 } },
      { subject: "SPLICE.getState.response", message_id: "another’s", state },
    ])
      await say(page, message);
    // No text can be made of it.
    await page.evaluate((ours) => {
      const document: Record<string, unknown> = { format: "gridworld" };
      document.self = document;
      window.frames[0]?.postMessage({ ...ours, command: "document", document }, "*");
    }, ours);
    // From the frame itself, and not from the page around it.
    await frame.locator("body").evaluate(() => {
      window.postMessage({ type: "mo-copp", version: 1, command: "step", step: 1 }, "*");
      return new Promise((done) => setTimeout(done, 300));
    });
    assert.equal(await frame.locator("mo-copp-playground").getAttribute("data-step"), "5");
    assert.equal(await frame.locator("mo-copp-playground").getAttribute("data-status"), "optimal");
    assert.equal(await frame.locator("body").getAttribute("data-scheme"), null);
    assert.equal(await frame.getByRole("alert").textContent(), "");
    const message_id = (await heard(page)).find(({ subject }) => subject === "SPLICE.getState")?.message_id;
    await say(page, { subject: "SPLICE.getState.response", message_id, state });
    await frame.locator('mo-copp-playground[data-step="1"]').waitFor();
  }));

test("a frame of a host without https says the same", () =>
  visit(async ({ page }) => {
    const host = "http://lecture.example/";
    await page.route(`${host}**`, async (route) =>
      route.fulfill({ response: await route.fetch({ url: route.request().url().replace(host, address) }) }),
    );
    await around(page, host);
    assert.equal(
      await page
        .frameLocator("iframe")
        .locator("body")
        .evaluate(() => window.isSecureContext),
      false,
    );
    await says(page, { ...ours, event: "state" });
    const uuid = /^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/;
    for (const subject of ["SPLICE.getState", "SPLICE.reportScoreAndState"])
      assert.match((await heard(page)).find((message) => message.subject === subject)?.message_id ?? "", uuid);
  }));
