// The kits for MkDocs and Sphinx: sites that these build, opened in Chromium.
import assert from "node:assert/strict";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { visit } from "../page/support/browser.js";
import { addPage, copyOf, kit, python, ready, served } from "./support/site.js";

test("MkDocs with Material: instant navigation and the switch to dark", () =>
  visit(
    async ({ page }) => {
      const folder = copyOf("mkdocs");
      addPage(join(folder, "docs", "mo-copp"));
      python(["-m", "mkdocs", "build", "--quiet", "--site-dir", "site"], folder);
      const address = await served(join(folder, "site"));
      await page.goto(address);
      await page.getByRole("link", { name: "The corridor" }).last().click();
      await ready(page, '[data-gd="1"]');
      assert.equal(await page.locator("#lab").getAttribute("data-scheme"), "light");
      await page.evaluate(() => document.body.setAttribute("data-md-color-scheme", "slate"));
      await page.waitForSelector("#lab[data-scheme=dark]");
      const size = await page
        .locator("#lab .title")
        .evaluate((part) => Number.parseFloat(getComputedStyle(part).fontSize));
      assert(size < 18, `${size}`);
      await page.getByRole("link", { name: "Back" }).click();
      await page.waitForSelector("#lab", { state: "detached" });
    },
    { ...kit, quiet: false },
  ));

test("MkDocs: a visit that begins at a page that is not there has the script, and other sites have none there", () =>
  visit(
    async ({ page }) => {
      const folder = copyOf("mkdocs");
      addPage(join(folder, "docs", "mo-copp"));
      const settings = join(folder, "mkdocs.yml");
      const given = readFileSync(settings, "utf8");
      const built = (site: string) => {
        python(["-m", "mkdocs", "build", "--quiet", "--site-dir", "site"], folder);
        return readFileSync(join(folder, "site", site), "utf8");
      };
      mkdirSync(join(folder, "site"));
      const address = await served(join(folder, "site"));
      writeFileSync(settings, given.replace("http://127.0.0.1/", address));
      const path = new URL(address).pathname;
      assert(built("404.html").includes(`<script type="module" src="${path}mo-copp/mo-copp-playground.js">`), path);
      await page.goto(`${address}404.html`);
      await page.evaluate("window.visit = 1");
      await page
        .locator(".md-nav")
        .getByRole("link", { name: "The corridor" })
        .first()
        .evaluate((link) => (link as HTMLElement).click());
      await ready(page, '[data-gd="1"]');
      assert.equal(await page.evaluate("window.visit"), 1, "the page was not loaded anew");
      writeFileSync(settings, given.replace("features: [navigation.instant]", "features: []"));
      assert(!built("404.html").includes("mo-copp"));
      assert(built("corridor/index.html").includes('src="../mo-copp/mo-copp-playground.js"'));
    },
    { ...kit, quiet: false },
  ));

test("Sphinx with the theme of Read the Docs: HTML gets the element, text its words", () =>
  visit(
    async ({ page, requests }) => {
      const folder = copyOf("sphinx");
      addPage(join(folder, "_static", "mo-copp"));
      for (const builder of ["html", "text"])
        python(["-m", "sphinx", "-q", "-b", builder, ".", `_build/${builder}`], folder);
      await page.goto(`${await served(join(folder, "_build", "html"))}index.html`);
      await ready(page, '[data-gd="1"]');
      const scripts = requests.filter((request) => request.includes("_static/mo-copp/mo-copp-playground.js"));
      assert.equal(scripts.length, 1, scripts.join(" "));
      assert.match(readFileSync(join(folder, "_build", "text", "index.txt"), "utf8"), /one step past the door/);
    },
    { ...kit, quiet: false },
  ));

test("Sphinx: every builder ends well; those of pages have the element, those of books, paper and text its words", () => {
  const folder = copyOf("sphinx");
  addPage(join(folder, "_static", "mo-copp"));
  mkdirSync(join(folder, "week"));
  writeFileSync(
    join(folder, "week", "two.rst"),
    "Week two\n========\n\n.. mo-copp::\n   :problem: delivery\n   :k: 2\n\n   Two **packages**.\n\n.. mo-copp::\n   :problem: corridor\n",
  );
  writeFileSync(join(folder, "index.rst"), "\n.. toctree::\n\n   week/two\n", { flag: "a" });
  const built = (builder: string) => {
    const told = python(["-m", "sphinx", "-q", "-b", builder, ".", `_build/${builder}`], folder);
    assert.doesNotMatch(told, /unknown node|Extension error/, builder);
    const out = join(folder, "_build", builder);
    const written = readdirSync(out, { recursive: true, encoding: "utf8" })
      .filter((file) => /\.(x?html|fjson|fpickle|xml|txt|pot|tex|texi|1)$/.test(file))
      .filter((file) => !/(^|\/)_s(tatic|ources)\//.test(file));
    return { out, text: written.map((file) => readFileSync(join(out, file), "latin1")).join("\n") };
  };
  const script = (text: string, address: string) =>
    text.split(`src=\\"${address}\\"`).length - 1 + text.split(`src="${address}"`).length - 1;
  const address = "_static/mo-copp/mo-copp-playground.js";
  const pages: [builder: string, index: string, week: string | null][] = [
    ["html", address, `../${address}`],
    ["dirhtml", address, `../../${address}`],
    ["singlehtml", address, null],
    ["json", address, `../../${address}`],
    ["pickle", address, `../../${address}`],
  ];
  for (const [builder, index, week] of pages) {
    const { text } = built(builder);
    assert(script(text, index) > 0, `${builder} has the script`);
    if (week !== null) assert(script(text, week) > 0, `${builder} has the script below a folder`);
    assert.match(text, /<mo-copp-playground problem=\\?"delivery\\?" k=\\?"2\\?">/, builder);
  }
  for (const builder of ["epub", "htmlhelp", "latex", "text", "man", "texinfo", "xml", "gettext"]) {
    const { out, text } = built(builder);
    assert.match(text, /Two\b[\s\S]{1,40}packages/, builder);
    assert.doesNotMatch(text, /mo-copp-playground|playground given/, builder);
    if (builder !== "epub") continue;
    const [book = ""] = readdirSync(out).filter((file) => file.endsWith(".epub"));
    const listed = python(["-m", "zipfile", "-l", join(out, book)], folder);
    assert.equal(listed.match(/^.*mo-copp.*$/m)?.[0], undefined, "no part of the script is in the book");
  }
});
