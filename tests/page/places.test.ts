// Files of the solver that are not where a page says: the message names the attribute, the address and what helps.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { dist } from "../../scripts/lib/paths.mjs";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { startHost } from "./support/host.js";

const home = await startHost();
/** Another host, which lets no other page read its files, and one that does. */
const closed = await startHost();
const open = await startHost({ "Access-Control-Allow-Origin": "*" });
const html = "<!doctype html><html lang='en'><title>Sign in</title></html>";
const file = (name: RegExp) => readdirSync(join(dist, "assets")).find((found) => name.test(found)) ?? assert.fail();
const core = readFileSync(join(dist, "assets", file(/^mo_copp_bg-.*\.wasm$/)));
const light = readFileSync(join(dist, "assets", file(/^mo_copp_light_bg-.*\.wasm$/)));
for (const host of [home, closed, open]) {
  host.own.set("lesson/page.html.wasm", { body: html, headers: { "Content-Type": "text/html" } });
  host.own.set("lesson/text.wasm", { body: html });
  host.own.set("lesson/core.wasm", { body: core });
  host.own.set("lesson/light.wasm", { body: light });
  host.own.set("lesson/html.js", { body: html });
  host.own.set("lesson/silent.js", { body: "self.silent = true" });
  host.own.set("lesson/chatty.js", { body: "postMessage(null)" });
  host.own.set("lesson/page.html.js", { body: html, headers: { "Content-Type": "text/html" } });
}

async function lesson(page: Page, attributes: string, script = "../mo-copp-playground.js"): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en"><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <script type="module" src="${script}"></script>
      <mo-copp-playground id="one" link="off" ${attributes}><script type="application/json">${grid()}</script></mo-copp-playground>`,
  });
  await page.goto(`${home.address}lesson/page.html`);
}

const alert = (page: Page) => page.locator("#one").getByRole("alert").first();

test("what worker-url and wasm-url name, and what is wrong with it", () =>
  visit(
    async ({ page }) => {
      const here = `${home.address}lesson/`;
      const cases: [attributes: string, said: string][] = [
        [
          'wasm-url="no.wasm"',
          `The solver could not be started: ${here}no.wasm was answered with 404; wasm-url names it.`,
        ],
        ['wasm-url="page.html.wasm"', `${here}page.html.wasm was answered with a page (HTML); wasm-url names it.`],
        ['wasm-url="text.wasm"', `${here}text.wasm is no WebAssembly; wasm-url names it.`],
        ['wasm-url="light.wasm"', "what wasm-url names, “light.wasm”, is not the core of this version: "],
        [
          `wasm-url="${closed.address}lesson/core.wasm"`,
          `${closed.address}lesson/core.wasm, which wasm-url names, could not be loaded: ${new URL(closed.address).host} must send it with “Access-Control-Allow-Origin”`,
        ],
        ['wasm-url="http://127.0.0.1:9/core.wasm"', "could not be loaded: 127.0.0.1:9 does not answer."],
        ['wasm-url="http://["', "“http://[” can’t be used for the attribute wasm-url; expected an address."],
        ['wasm-url=""', "“” can’t be used for the attribute wasm-url; expected an address."],
        ['worker-url="http://["', "“http://[” can’t be used for the attribute worker-url; expected an address."],
        ...["worker-url", "wasm-url"].map((name): [string, string] => [
          `${name}="javascript:alert(1)"`,
          `“javascript:alert(1)” can’t be used for the attribute ${name}; expected an address by https:, http:, data:`,
        ]),
        ['worker-url="blob:null/abc"', "could not be loaded: no such blob is known to this page"],
        ['worker-url="html.js"', "what worker-url names, “html.js”, is not its script: "],
        ['worker-url="chatty.js"', "what worker-url names, “chatty.js”, is not its script: its first message is none"],
        ['worker-url="page.html.js"', "what worker-url names, “page.html.js”, is not its script: "],
        [
          `worker-url="${closed.address}lesson/html.js"`,
          `${closed.address}lesson/html.js, which worker-url names, could not be loaded: `,
        ],
        [`worker-url="${open.address}lesson/page.html.js"`, "was answered with a page (HTML); worker-url names it."],
        [`worker-url="${open.address}lesson/no.js"`, "lesson/no.js was answered with 404; worker-url names it."],
      ];
      for (const [attributes, said] of cases) {
        await lesson(page, attributes);
        await page.waitForSelector("#one[data-status=error]");
        const text = (await alert(page).textContent()) ?? "";
        assert(text.includes(said), `${attributes}: ${text}`);
        assert(!/Access-Control/.test(text) || attributes.includes(closed.address), `${attributes}: ${text}`);
        assert.equal(await alert(page).getByRole("button", { name: "Try again" }).count(), 1, attributes);
      }
    },
    { quiet: false },
  ));

test("a worker-url whose script runs and is not the worker is said, and tried again", () =>
  visit(
    async ({ page }) => {
      const silent = (page: Page) =>
        alert(page)
          .getByText("what worker-url names, “silent.js”, is not its script: it runs, and gives no sign.")
          .waitFor();
      await lesson(page, 'worker-url="silent.js"');
      await silent(page);
      const worker = readFileSync(join(dist, "assets", file(/^solver\.worker-.*\.js$/)));
      home.own.set("lesson/silent.js", { body: worker });
      await alert(page).getByRole("button", { name: "Try again" }).click();
      await page.waitForSelector("#one[data-status=optimal]");
    },
    { quiet: false },
  ));

test("a core that comes later is asked for again, by the page and by its worker", () =>
  visit(
    async ({ page }) => {
      await lesson(page, 'wasm-url="late.wasm"');
      await alert(page).getByText("late.wasm was answered with 404").waitFor();
      home.own.set("lesson/late.wasm", { body: core });
      await alert(page).getByRole("button", { name: "Try again" }).click();
      await page.waitForSelector("#one[data-status=optimal]");
      // From another host the page fetches both cores for the worker.
      const any = /mo_copp(_light)?_bg[^/]*\.wasm/;
      await page.route(any, (route) => route.abort());
      await lesson(page, "", `${open.address}mo-copp-playground.js`);
      await alert(page).getByText("does not answer. Check the connection and the address, then try again.").waitFor();
      await page.unroute(any);
      await alert(page).getByRole("button", { name: "Try again" }).click();
      await page.waitForSelector("#one[data-status=optimal]");
    },
    { quiet: false },
  ));

test("a worker's script that does not come is said once", () =>
  visit(
    async ({ page }) => {
      await page.route("**/solver.worker-*.js", (route) => route.abort());
      await lesson(page, "");
      await alert(page)
        .getByText(
          /could not be started: http[^ ]*solver\.worker-[^ ]*\.js could not be loaded: .* does not answer\. Check/,
        )
        .waitFor();
      await page.unroute("**/solver.worker-*.js");
      // A host that answers with a page for what it lacks.
      await page.route(/mo_copp_light_bg[^/]*\.wasm/, (route) =>
        route.fulfill({ contentType: "text/html", body: html }),
      );
      await alert(page).getByRole("button", { name: "Try again" }).click();
      await alert(page)
        .getByText(/mo_copp_light_bg[^/]*\.wasm was answered with a page \(HTML\)\./)
        .waitFor();
    },
    { quiet: false },
  ));
