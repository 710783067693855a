// What could not be loaded is tried again by one click, and said in words that help; what no second try helps has no such
// button.
import assert from "node:assert/strict";
import { Readable } from "node:stream";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { LARGEST_DOCUMENT } from "../../www/src/problem/limits.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { type Answer, startHost } from "./support/host.js";

const home = await startHost();
/** Another host, which lets no other page read its files. */
const other = await startHost();
other.own.set("grid.json", { body: grid() });

async function lesson(page: Page, attributes: string, prose = ""): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en"><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <script type="module" src="../mo-copp-playground.js"></script>${prose}
      <mo-copp-playground id="one" link="off" ${attributes}></mo-copp-playground>`,
  });
  await page.goto(`${home.address}lesson/page.html`);
}

const alert = (page: Page) => page.locator("#one").getByRole("alert").first();
const again = (page: Page) => alert(page).getByRole("button", { name: "Try again" });
const ready = (page: Page, more = "") =>
  page.waitForSelector(`#one:is([data-status=optimal], [data-status=solved])${more}`);
const titled = (page: Page, title: string) => page.locator("#one .title", { hasText: title }).first().waitFor();

const core = /mo_copp_bg-[^/]*\.wasm/;
const noCore =
  /could not be loaded\. Your problem is as it was\. http\S+\.wasm could not be loaded\. Check the connection, then try again\./;

test("a part of the core that did not come is asked for again, for whatever needed it", () =>
  visit(
    async ({ page }) => {
      const exercise = JSON.parse(grid({ exercise: { kind: "best" } }));
      const link = (name: string, value: string) =>
        `<button id="${name}" data-mo-copp-for="one" data-mo-copp-set-${name}="${value}">${name}</button>`;
      await page.route(core, (route) => route.abort());
      // A link of the prose, clicked once more.
      await lesson(page, 'problem="corridor"', link("problem", "blocks-unseen") + link("solver", "ip"));
      await ready(page, '[data-step="5"]');
      await page.locator("#problem").click();
      await alert(page).getByText(noCore).waitFor();
      await again(page).waitFor();
      await page.locator("#problem").click();
      await alert(page).getByText(noCore).waitFor();
      await page.unroute(core);
      await page.locator("#problem").click();
      await titled(page, "Towers in the dark");
      // What is said has a button.
      const ways: [name: string, attributes: string, act: () => Promise<unknown>, done: () => Promise<unknown>][] = [
        [
          "a link to a problem",
          'problem="corridor"',
          () => page.locator("#problem").click(),
          () => titled(page, "Towers in the dark"),
        ],
        [
          "a link to a solver",
          'problem="corridor" horizon="5"',
          () => page.locator("#solver").click(),
          () => page.waitForFunction(() => document.querySelector("#one")?.shadowRoot?.querySelector("select[id]")),
        ],
        ["the gallery", 'problem="blocks"', async () => undefined, () => titled(page, "Towers of blocks")],
        [
          "a document of a script",
          'problem="corridor"',
          () =>
            page.evaluate((document_) => {
              Object.assign(document.querySelector("#one") as HTMLElement, { document: document_ });
            }, exercise),
          () => page.locator("#one .exercise .question").waitFor(),
        ],
        [
          "a solver chosen by hand",
          'problem="corridor"',
          async () => {
            await page.locator("#one").getByLabel("Solver").selectOption("search");
            await page.locator("#one").getByRole("button", { name: "Solve", exact: true }).click();
          },
          () => ready(page, "[data-status=solved]"),
        ],
      ];
      for (const [name, attributes, act, done] of ways) {
        await page.route(core, (route) => route.abort());
        await lesson(page, attributes, link("problem", "blocks-unseen") + link("solver", "ip"));
        if (attributes !== 'problem="blocks"') await ready(page);
        await act();
        await alert(page).getByText(noCore).waitFor();
        await again(page).click();
        await alert(page).getByText(noCore).waitFor();
        await page.unroute(core);
        await again(page).click();
        await done();
        await page.waitForFunction(
          () => (document.querySelector("#one")?.shadowRoot?.querySelector("[role=alert]")?.textContent ?? "") === "",
        );
        assert.notEqual(await page.locator("#one").getAttribute("data-status"), "error", name);
      }
    },
    { quiet: false },
  ));

test("a gallery that did not come is asked for again", () =>
  visit(
    async ({ page }) => {
      await page.route("**/documents-*.js", (route) => route.abort());
      await lesson(page, 'problem="corridor" step="2"');
      await alert(page).getByText("The gallery could not be loaded. Check the connection, then try again.").waitFor();
      await page.unroute("**/documents-*.js");
      await again(page).click();
      await ready(page, '[data-step="2"]');
    },
    { quiet: false },
  ));

test("a document that can't be had is said with its address and what helps, and with a button where that may help", () =>
  visit(
    async ({ page }) => {
      home.own.set("lesson/page.json", { body: "<!doctype html><title>Sign in</title>" });
      home.own.set("lesson/text.json", { body: "hello" });
      home.own.set("lesson/wrong.json", { body: grid({ start: [9, 9] }) });
      home.own.set("lesson/exercise.json", { body: grid({ exercise: { kind: "nothing" } }) });
      const inside = "A document may stand in the element itself";
      const cases: [src: string, said: (string | RegExp)[], button: boolean][] = [
        [`${other.address}grid.json`, [/must send it with “Access-Control-Allow-Origin”/, inside], false],
        ["http://127.0.0.1:9/grid.json", ["127.0.0.1:9 does not answer. Check the connection and the address"], true],
        ["page.json", [`${home.address}lesson/page.json was answered with a page (HTML), and not with JSON`], false],
        ["text.json", [/“text.json”, line 1, column 1: .+ the line reads: hello/], false],
        ["wrong.json", ["“wrong.json”,", /start/], false],
        ["exercise.json", ["“exercise.json”", /kind/], false],
        ["nowhere.json", [`${home.address}lesson/nowhere.json was answered with 404`], true],
        ["", ["The attribute src is empty"], false],
        ["http://[", ["this is no address"], false],
        [
          "blob:null/abc",
          ["no such blob is known to this page: it was made by another one, or is gone.", inside],
          false,
        ],
        ["file:///a/b.json", ["browsers let a page of a host read no file of a disk.", inside], false],
        ["data:x", ["this is no data: address that can be read.", inside], false],
      ];
      for (const [src, said, button] of cases) {
        await lesson(page, `src="${src}"`);
        for (const words of said) await alert(page).getByText(words).waitFor();
        assert.equal(await again(page).count(), button ? 1 : 0, src);
      }
      // What the page itself got wrong is put right there.
      for (const [attributes, words] of [
        ['problem="nowhere"', /“nowhere” in the gallery; expected eight-by-eight, head-fake, .*driverlog\.$/],
        ['problem="corridor" seed="x"', "“x” can’t be used for the attribute seed"],
        [`src="exercise.json" seed="x"`, "“x” can’t be used for the attribute seed"],
      ] as const) {
        await lesson(page, attributes);
        await alert(page).getByText(words).waitFor();
        assert.equal(await again(page).count(), 0, attributes);
      }
    },
    { quiet: false },
  ));

test("a document that does not come is told of while it is waited for, and then given up, to be tried again", () =>
  visit(
    async ({ page }) => {
      await page.clock.install();
      await page.route("**/slow.json", () => undefined);
      await lesson(page, 'src="slow.json"');
      await page.locator("#one").waitFor();
      const says = async (text: string) => {
        while (!(await alert(page).getByText(text).isVisible())) await page.clock.runFor(1000);
      };
      await says("Still waiting for the problem document “slow.json”.");
      await says("did not answer in 30 seconds.");
      await page.unroute("**/slow.json");
      home.own.set("lesson/slow.json", { body: grid() });
      await again(page).click();
      while (!(await page.locator("#one[data-status=optimal]").isVisible())) await page.clock.runFor(100);
      assert.equal(await page.getByText("did not answer").count(), 0);
    },
    { quiet: false },
  ));

test("a document that stops on its way is given up, to be tried again, and one that is slow is not", () =>
  visit(
    async ({ page }) => {
      await page.clock.install();
      const [text, parts] = [grid(), 4];
      let next = 0;
      let send = () => {};
      home.own.set("lesson/slow.json", {
        body: (response) => {
          next = 0;
          send = () => {
            const size = Math.ceil(text.length / parts);
            response.write(text.slice(next * size, (next + 1) * size));
            next += 1;
            if (next === parts) response.end();
          };
          send();
        },
      });
      await lesson(page, 'problem="corridor"');
      const until = async (selector: string) => {
        while (!(await page.locator(selector).first().isVisible())) await page.clock.runFor(100);
      };
      await until("#one[data-status=optimal]");
      await page.evaluate(() => {
        const { read } = ReadableStreamDefaultReader.prototype;
        const seen = { parts: 0, solved: "" };
        Object.assign(globalThis, { seen });
        ReadableStreamDefaultReader.prototype.read = async function () {
          const part = await read.call(this);
          seen.parts += 1;
          return part as never;
        };
        const one = document.querySelector("#one") as HTMLElement & { src: string; solve(): Promise<unknown> };
        one.src = "slow.json";
        one.solve().then(
          () => {
            seen.solved = "solved";
          },
          (error: Error) => {
            seen.solved = error.message;
          },
        );
      });
      const seen = () =>
        page.evaluate(() => (globalThis as unknown as { seen: { parts: number; solved: string } }).seen);
      const came = async (count: number) => {
        while ((await seen()).parts < count);
      };
      // What has begun and stops is what does not answer.
      await came(1);
      await page.clock.runFor(29_000);
      assert.equal((await seen()).solved, "");
      await page.clock.runFor(2000);
      await alert(page).getByText("/slow.json did not answer in 30 seconds.").waitFor();
      assert.match((await seen()).solved, /did not answer in 30 seconds/);
      // What goes on takes as long as it takes.
      const before = (await seen()).parts;
      await again(page).click();
      for (let count = 1; count < parts; count++) {
        await came(before + count);
        await page.clock.runFor(29_000);
        send();
      }
      while ((await alert(page).textContent()) !== "") await page.clock.runFor(100);
      await until("#one[data-status=optimal]");
      assert.equal(await page.locator("#one .title", { hasText: "Corridor" }).count(), 0, "the document came");
    },
    { quiet: false },
  ));

test("a document that breaks off on its way says so, with a button", () =>
  visit(
    async ({ page }) => {
      const broken: Answer = {
        headers: { "Access-Control-Allow-Origin": "*" },
        body: (response) => response.write("{", () => response.destroy()),
      };
      for (const host of [home, other]) {
        host.own.set("lesson/broken.json", broken);
        await lesson(page, `src="${host.address}lesson/broken.json"`);
        await alert(page).getByText("/lesson/broken.json broke off. Check the connection, then try again.").waitFor();
        assert.equal(await again(page).count(), 1, host.address);
      }
    },
    { quiet: false },
  ));

test("a document over the limit is read no further than that, whether or not it tells its length", () =>
  visit(
    async ({ page }) => {
      const whole = 64 * LARGEST_DOCUMENT;
      const part = " ".repeat(LARGEST_DOCUMENT / 8);
      for (const headers of [{}, { "Content-Length": `${whole}` }]) {
        const sent = new Promise<number>((over) => {
          home.own.set("lesson/large.json", {
            headers,
            body: (response) => {
              let bytes = 0;
              function* parts() {
                for (; bytes < whole; bytes += part.length) yield part;
              }
              response.on("close", () => over(bytes));
              Readable.from(parts()).pipe(response);
            },
          });
        });
        await lesson(page, 'src="large.json"');
        await alert(page).getByText("“large.json” is too large: at most 8 MiB can be opened.").waitFor();
        assert.equal(await again(page).count(), 0, "a second try does not help");
        assert((await sent) < whole, `cancelled, with ${Object.keys(headers)}`);
      }
    },
    { quiet: false },
  ));
