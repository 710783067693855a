// The ways to load the element: from any host, in any frame, and without a server. Each solves a problem.
import assert from "node:assert/strict";
import { copyFileSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { runInThisContext } from "node:vm";
import { gzipSync } from "node:zlib";
import type { Frame, Page } from "playwright-core";
import { dist, inRoot } from "../../scripts/lib/paths.mjs";
import { inAscii } from "../../scripts/page/ascii.mjs";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { startHost } from "./support/host.js";

const home = await startHost();
/** Another host, which lets every page read its files. */
const other = await startHost({ "Access-Control-Allow-Origin": "*" });

const inline = `<script type="application/json">${grid()}</script>`;
const one = `<mo-copp-playground id="one" link="off">${inline}</mo-copp-playground>`;
const solved = (where: Page | Frame) => where.waitForSelector("#one[data-status=optimal][data-gd]");

/** A page on the host of the built page, under a content policy. */
async function host(page: Page, body: string, policy = ""): Promise<void> {
  home.own.set("lesson/way.html", {
    body: `<!doctype html><html lang="en"><head><meta charset="utf-8"><link rel="icon" href="data:,"><title>Way</title></head><body>${body}</body></html>`,
    headers: policy === "" ? {} : { "Content-Security-Policy": policy },
  });
  await page.goto(`${home.address}lesson/way.html`);
}

const own = `<script type="module" src="../mo-copp-playground.js"></script>`;
const fromOther = `<script type="module" src="${other.address}mo-copp-playground.js"></script>`;
const single = `<script src="../mo-copp-playground.single.js"></script>`;

/** The policies that docs/embedding.md says each way needs. */
const sameHost =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; img-src 'self' data:";
const hostOf = new URL(other.address).origin;
const otherHost = `default-src 'none'; script-src ${hostOf} 'wasm-unsafe-eval'; worker-src blob:; connect-src ${hostOf}; img-src 'self' data:`;
const oneFile = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; img-src 'self' data:";

for (const [name, body, policy] of [
  ["the same host", own + one, sameHost],
  ["another host", fromOther + one, otherHost],
  ["one file on the same host", single + one, oneFile],
] as const) {
  test(`from ${name}, under the policy that is said to be enough`, () =>
    visit(async ({ page }) => {
      await host(page, body, policy);
      await solved(page);
    }));
}

for (const [name, script] of [
  ["another host", fromOther],
  ["one file", `<script src="${other.address}mo-copp-playground.single.js"></script>`],
] as const) {
  test(`in a frame with sandbox="allow-scripts": ${name}`, () =>
    visit(async ({ page }) => {
      const inner = `<!doctype html><html lang="en"><title>Frame</title>${script}${one}`.replaceAll('"', "&quot;");
      await host(page, `<iframe sandbox="allow-scripts" srcdoc="${inner}" title="Way"></iframe>`);
      await page.frameLocator("iframe").locator("#one[data-status=optimal]").waitFor();
    }));
}

test("as one file from disk, renamed beside its page", () =>
  visit(async ({ page }) => {
    const folder = mkdtempSync(join(tmpdir(), "mo-copp-"));
    try {
      copyFileSync(join(dist, "mo-copp-playground.single.js"), join(folder, "playground.js"));
      writeFileSync(
        join(folder, "page.html"),
        `<!doctype html><html lang="en"><title>From disk</title><script src="playground.js"></script>${one}`,
      );
      await page.goto(pathToFileURL(join(folder, "page.html")).href);
      await solved(page);
      // What takes the full core is there, too.
      await page.locator("#one").getByLabel("Solver").selectOption("ip");
      await page.locator("#one").getByLabel("Plan length").fill("4");
    } finally {
      rmSync(folder, { recursive: true });
    }
  }));

test("the one script is ASCII alone, and so the same in a page of another charset", () =>
  visit(async ({ page }) => {
    const script = readFileSync(join(dist, "mo-copp-playground.single.js"));
    const other = script.findIndex((byte) => byte > 127);
    assert.equal(other, -1, `at byte ${other}: ${script.subarray(other - 40, other + 20)}`);
    // Escapes mean what the characters did, in texts, templates and patterns.
    for (const text of [
      "`a\u2014\ud835\udca2`",
      "'\\\\\u2014'",
      "'\\\u2014'",
      "/^[\u2019\ud835\udca2-\ud835\udcac]$/u.test('\ud835\udca5')",
    ])
      assert.equal(runInThisContext(inAscii(text)), runInThisContext(text), text);
    // Neither the page nor the script says what charset it has.
    home.own.set("lesson/single.js", { body: script, headers: { "Content-Type": "text/javascript" } });
    home.own.set("lesson/charset.html", {
      body: `<!doctype html><html lang="en"><title>Way</title><link rel="icon" href="data:,"><script src="single.js"></script>${one}`,
      headers: { "Content-Type": "text/html; charset=windows-1252" },
    });
    await page.goto(`${home.address}lesson/charset.html`);
    await solved(page);
    assert.equal(await page.evaluate(() => document.characterSet), "windows-1252");
    const text = await page.locator("#one").evaluate((playground) => playground.shadowRoot?.textContent ?? "");
    assert.match(text, /[\u2019\u2192\u2026]/, "there are characters beyond ASCII");
    assert.doesNotMatch(text, /\u00e2|\u00c3|\ufffd/, "and all of them are right");
  }));

test("as a script and as a page from a blob", () =>
  visit(async ({ page }) => {
    await host(page, one);
    await page.evaluate(async (script) => {
      const text = await (await fetch(script)).text();
      const blob = new Blob([text], { type: "text/javascript" });
      await import(URL.createObjectURL(blob));
    }, `${home.address}mo-copp-playground.single.js`);
    await solved(page);
    const inner = `<!doctype html><title>Blob</title>${fromOther}${one}`;
    const [frame] = await Promise.all([
      page.waitForEvent("frameattached"),
      page.evaluate((text) => {
        const frame = document.createElement("iframe");
        frame.src = URL.createObjectURL(new Blob([text], { type: "text/html" }));
        document.body.append(frame);
      }, inner),
    ]);
    await solved(frame);
  }));

test("under an embedder policy that the page has and the worker's script has not", () =>
  visit(
    async ({ page }) => {
      const headers = { "Cross-Origin-Embedder-Policy": "require-corp" };
      const worker = readdirSync(join(dist, "assets")).find((file) => /^solver\.worker-[^/]+\.js$/.test(file)) ?? "";
      const placed = one.replace("link=", `worker-url="../assets/${worker}" link=`);
      for (const body of [own + one, single + one, own + placed]) {
        home.own.set("lesson/embedder.html", {
          body: `<!doctype html><html lang="en"><meta charset="utf-8"><title>Way</title>${body}`,
          headers,
        });
        await page.goto(`${home.address}lesson/embedder.html`);
        await solved(page);
        // What takes the full core is there, too.
        await page.locator("#one").evaluate((playground) => (playground as MoCoppPlayground).toSVG());
      }
      // Where the script is not there either, that is said as ever.
      home.own.set("lesson/embedder.html", {
        body: `<!doctype html><html lang="en"><meta charset="utf-8"><title>Way</title>${own}${placed.replace(worker, "no-worker.js")}`,
        headers,
      });
      await page.goto(`${home.address}lesson/embedder.html`);
      await page.locator("#one").getByRole("alert").getByText("no script came from worker-url").first().waitFor();
    },
    { quiet: false },
  ));

test("files that the page places itself are those that are used", () =>
  visit(async ({ page, requests }) => {
    const files = { worker: /assets\/solver\.worker-[^/]+\.js/, wasm: /assets\/mo_copp_bg-[^/]+\.wasm/ };
    const named = readdirSync(join(dist, "assets")).map((file) => `assets/${file}`);
    const [worker = "", wasm = ""] = [files.worker, files.wasm].map((name) => named.find((file) => name.test(file)));
    for (const [from, to] of [
      ["own-worker.js", worker],
      ["own-core.wasm", wasm],
    ] as const) {
      home.own.set(`lesson/${from}`, { body: readFileSync(join(dist, to)) });
    }
    requests.length = 0;
    const placed = one.replace("link=", `worker-url="own-worker.js" wasm-url="own-core.wasm" link=`);
    await host(page, own + placed, sameHost);
    await solved(page);
    const placedHere = requests.filter((request) => request.startsWith(home.address));
    for (const file of ["own-worker.js", "own-core.wasm"])
      assert(placedHere.includes(`${home.address}lesson/${file}`), placedHere.join(" "));
    assert(!placedHere.some((request) => request.endsWith(worker)), placedHere.join(" "));
  }));

for (const [name, script] of [
  ["the script", own],
  ["one file", single],
] as const) {
  test(`where a page adds names to all objects: ${name}`, () =>
    visit(async ({ page }) => {
      await host(page, `<script>Object.prototype.version = 1; Array.prototype.extra = "more";</script>${script}${one}`);
      await solved(page);
      for (const tab of ["Edit", "Compare", "Trade-off", "Exercise", "Steps"]) {
        await page.locator("#one").getByRole("tab", { name: tab }).click();
        const panel = page.locator("#one").getByRole("tabpanel", { name: tab });
        await panel.locator("button, input, table").first().waitFor({ state: "attached" });
      }
    }));
}

test("a worker that is forbidden, wasm that is forbidden, an address that answers nothing: said with what to do", () =>
  visit(
    async ({ page }) => {
      await host(page, own + one, sameHost.replace("worker-src 'self'", "worker-src 'none'"));
      const alert = page.locator("#one").getByRole("alert").first();
      await alert.getByText("must allow worker-src 'self'").waitFor();
      await alert.getByRole("button", { name: "Try again" }).waitFor();
      await host(page, single + one, oneFile.replace(" 'wasm-unsafe-eval'", ""));
      await alert.getByText("must allow 'wasm-unsafe-eval' in script-src").waitFor();
      // A worker that the page places, and that is not there, has a name.
      await host(page, own + one.replace("link=", `worker-url="no-worker.js" link=`), sameHost);
      await alert.getByText("no script came from worker-url, “no-worker.js”").waitFor();
      // A document that may not be fetched may stand in the page.
      const elsewhere = `<mo-copp-playground id="one" src="${other.address}grid.json" link="off"></mo-copp-playground>`;
      await host(page, own + elsewhere, sameHost);
      await alert.getByText("must allow its host in connect-src. A document may stand in the element itself").waitFor();
      const folder = mkdtempSync(join(tmpdir(), "mo-copp-"));
      try {
        copyFileSync(join(dist, "mo-copp-playground.single.js"), join(folder, "playground.js"));
        const text = `<!doctype html><html lang="en"><title>From disk</title><script src="playground.js"></script>`;
        writeFileSync(join(folder, "page.html"), text + elsewhere.replace(other.address, ""));
        await page.goto(pathToFileURL(join(folder, "page.html")).href);
        await alert.getByText("browsers let a page on a disk read no other file. A document may stand in").waitFor();
      } finally {
        rmSync(folder, { recursive: true });
      }
      // A second try is one click.
      await host(page, `${own}<mo-copp-playground id="one" src="late.json" link="off"></mo-copp-playground>`);
      await alert.getByText("“late.json” could not be loaded").waitFor();
      home.own.set("lesson/late.json", { body: grid() });
      await alert.getByRole("button", { name: "Try again" }).click();
      await solved(page);
      home.own.set("lesson/large.json", { body: " ".repeat(8 * 1024 * 1024 + 1) });
      await page.evaluate(() => document.querySelector("#one")?.setAttribute("src", "large.json"));
      await alert.getByText("“large.json” is too large: at most 8 MiB").waitFor();
      assert.equal(await page.locator("#one [data-board=actor]").count(), 1);
    },
    { quiet: false },
  ));

test("in a page that is sent as XHTML a sentence takes the playground's place", () =>
  visit(
    async ({ page }) => {
      home.own.set("lesson/way.xhtml", {
        body: `<html xmlns="http://www.w3.org/1999/xhtml" lang="en"><head><title>Way</title><link rel="icon" href="data:,"/>
          ${single}</head><body><mo-copp-playground id="one">${inline}</mo-copp-playground></body></html>`,
        headers: { "Content-Type": "application/xhtml+xml" },
      });
      await page.goto(`${home.address}lesson/way.xhtml`);
      const alert = page.locator("#one").getByRole("alert");
      await alert.getByText("in a page that is sent as application/xhtml+xml; expected text/html.").waitFor();
      assert.equal(await alert.getByRole("button").count(), 0);
      await page.waitForSelector("#one[data-status=error]");
    },
    { quiet: false },
  ));

test("where the page requires Trusted Types the folder runs, and what its policy must allow is said", () =>
  visit(
    async ({ page, errors }) => {
      const alert = page.locator("#one").getByRole("alert").first();
      const required = `${sameHost}; require-trusted-types-for 'script'`;
      for (const policy of [required, `${required}; trusted-types lit-html mo-copp`]) {
        await host(page, own + one, policy);
        await solved(page);
        await page.locator("#one").getByRole("tab", { name: "Document" }).click();
        await page.locator("#one .cm-content").waitFor();
      }
      // Nothing is refused, and so nothing is reported.
      assert.deepEqual(errors, []);
      await host(page, own + one, `${required}; trusted-types lit-html`);
      await alert.getByText("trusted-types of the page’s content policy must allow mo-copp").waitFor();
      await host(page, own + one, `${required}; trusted-types 'none'`);
      await alert.getByText("trusted-types of the page’s content policy must allow lit-html and mo-copp.").waitFor();
      assert.equal(await alert.getByRole("button").count(), 0);
      await host(page, single + one, `${oneFile}; require-trusted-types-for 'script'`);
      await alert.getByText("requires Trusted Types: the element as a folder can run there").waitFor();
    },
    { quiet: false },
  ));

test("the one file is at most 900 kB on its way, as the guide says", () => {
  const bytes = gzipSync(readFileSync(join(dist, "mo-copp-playground.single.js")), { level: 9 }).length;
  assert(bytes <= 900_000, `${bytes} bytes`);
  const guide = readFileSync(inRoot("docs", "embedding.md"), "utf8");
  const [, said] = /The one script is about ([\d.]+) MB on its way/.exec(guide) ?? [];
  assert.equal(said, (bytes / 1e6).toFixed(1));
});
