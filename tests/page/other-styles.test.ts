// The element in pages with other people's style sheets looks as in a page without any, by comparing pictures.
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import pixelmatch from "pixelmatch";
import type { Page } from "playwright-core";
import { PNG } from "pngjs";
import { nodeModules, venv } from "../../scripts/lib/paths.mjs";
import { visit } from "./support/browser.js";
import { address } from "./support/site.js";

/** How much of the pixels may differ. */
const MOST_APART = 0.005;

interface Style {
  name: string;
  css: string;
  /** The markup that the style sheet is made for, around the element. */
  around?: (inner: string) => string;
  /** What the page begins with, in place of the doctype. */
  doctype?: string;
}

const npm = (...parts: string[]) => readFileSync(join(nodeModules, ...parts), "utf8");

/** A file of a Python package in the project's own environment. */
function python(folder: string, name: RegExp): string {
  const lib = join(venv, "lib");
  const packages = readdirSync(lib).map((version) => join(lib, version, "site-packages", folder));
  const found = packages.find((path) => existsSync(path));
  assert(found, `${folder} is not in .tools/venv; run npm run setup`);
  const file = readdirSync(found, { recursive: true })
    .map(String)
    .find((path) => name.test(path));
  assert(file, `${folder} has no ${name}`);
  return readFileSync(join(found, file), "utf8");
}

/** What the element's styles have of custom properties that no page sets. */
function ownProperties(): string[] {
  const folder = new URL("../../www/src/style/", import.meta.url);
  const texts = readdirSync(folder).map((file) => readFileSync(new URL(file, folder), "utf8"));
  const names = texts.flatMap((text) =>
    [...text.matchAll(/(?<![\w-])--(?!mo-copp-)([a-z-]+)/g)].map(([, name = ""]) => name),
  );
  const found = [...new Set(names)];
  assert(found.length > 20, "the styles have custom properties");
  return found;
}

const styles: readonly Style[] = [
  {
    name: "Bootstrap 5.3",
    css: npm("bootstrap", "dist", "css", "bootstrap.css"),
    around: (inner) => `<main class="container"><div class="row"><div class="col">${inner}</div></div></main>`,
  },
  {
    name: "Bulma",
    css: npm("bulma", "css", "bulma.css"),
    around: (inner) => `<section class="section"><div class="content">${inner}</div></section>`,
  },
  {
    name: "Pico",
    css: npm("@picocss", "pico", "css", "pico.css"),
    around: (inner) => `<main class="container"><article>${inner}</article></main>`,
  },
  {
    name: "Material for MkDocs",
    css:
      python("material", /templates.assets.stylesheets.main\.[^/]*\.css$/) +
      python("material", /templates.assets.stylesheets.palette\.[^/]*\.css$/),
    around: (inner) => `<article class="md-content__inner md-typeset">${inner}</article>`,
  },
  {
    name: "Read the Docs",
    css: python("sphinx_rtd_theme", /static.css.theme\.css$/),
    around: (inner) =>
      `<div class="wy-nav-content"><div class="rst-content"><div class="document">${inner}</div></div></div>`,
  },
  {
    name: "reveal.js",
    css:
      npm("reveal.js", "dist", "reset.css") +
      npm("reveal.js", "dist", "reveal.css") +
      npm("reveal.js", "dist", "theme", "black.css"),
    around: (inner) =>
      `<div class="reveal" style="height: 3000px; overflow: visible"><div class="slides"><section class="present">${inner}</section></div></div>`,
  },
  {
    name: "GitHub markdown",
    css: npm("github-markdown-css", "github-markdown.css"),
    around: (inner) => `<article class="markdown-body">${inner}</article>`,
  },
  {
    name: "a hostile reset",
    css: "* { all: revert } div { float: left } * { letter-spacing: 3px; text-transform: uppercase; visibility: visible }",
  },
  {
    name: "registered properties",
    css: [..."ink card line paper muted floor wall enemy friend focus".split(" ")]
      .map(
        (name) =>
          `@property --${name} { syntax: "<color>"; inherits: false; initial-value: ${name === "card" ? "lime" : "red"} }`,
      )
      .join(" "),
  },
  {
    name: "registered properties of the element's own",
    css: ["--mo-copp-rem", ...ownProperties().flatMap((name) => [`--${name}`, `--mo-copp-own-${name}`])]
      .map((name, index) => {
        const syntaxes = [
          '"<color>"; initial-value: red',
          '"<length>"; initial-value: 0px',
          '"*"; initial-value: lime',
        ];
        return `@property ${name} { syntax: ${syntaxes[index % syntaxes.length]}; inherits: false }`;
      })
      .join(" "),
  },
  {
    name: "inherited properties",
    css: "body { font: italic 700 40px/3 serif; color: red; text-align: right; letter-spacing: 4px; word-spacing: 9px; text-transform: uppercase; white-space: pre; cursor: wait; text-shadow: 3px 3px red; list-style: upper-roman; --ink: red; --card: lime; --line: blue }",
    around: (inner) => `<div dir="rtl">${inner}</div>`,
  },
  {
    name: "lines under and through text",
    css: "* { text-decoration: underline wavy red 3px } .done { text-decoration: line-through !important }",
    around: (inner) => `<div class="done"><u><s>${inner}</s></u></div>`,
  },
  {
    name: "text before and after the element and all in it",
    css: `mo-copp-playground::before, mo-copp-playground::after, mo-copp-playground *::before { content: "x" !important; display: block !important }`,
  },
];

const elements = [
  `<mo-copp-playground problem="corridor" link="off"></mo-copp-playground>`,
  `<mo-copp-playground problem="delivery" hide="workbench" link="off"></mo-copp-playground>`,
].join("");

/** The size of the root's text is the page's to decide: it is the same in all of these. */
function lesson({ css, around = (inner) => inner, doctype = "<!doctype html>" }: Style, body = elements): string {
  return `${doctype}<html lang="en" data-theme="light"><head><title>Lesson</title><meta charset="utf-8">
    <style>${css.replaceAll("</style", "")}</style>
    <style>html { font-size: 16px !important }
      #frame { position: absolute !important; inset: 0 auto auto 0 !important; width: 1160px !important; max-width: none !important;
        float: none !important; display: block !important; padding: 0 !important; margin: 0 !important }</style>
    <script type="module" src="../mo-copp-playground.js"></script></head>
    <body>${around(`<div id="frame">${body}</div>`)}</body></html>`;
}

async function picture(page: Page, style: Style, tab = "Solve"): Promise<PNG> {
  await page.route(`${address}lesson/styled.html`, (route) =>
    route.fulfill({ contentType: "text/html", body: lesson(style) }),
  );
  await page.goto(`${address}lesson/styled.html`);
  await page.waitForFunction(
    () => document.querySelectorAll("mo-copp-playground:is([data-status=optimal], [data-status=solved])").length === 2,
  );
  await page.getByRole("tab", { name: tab, exact: true }).first().click();
  await page
    .locator(tab === "Steps" ? ".steps table" : ".workbench form")
    .first()
    .waitFor();
  await page.evaluate(() => {
    scrollTo(0, 0);
    (document.activeElement as HTMLElement).blur();
  });
  const bytes = await page.locator("#frame").screenshot({ animations: "disabled", caret: "hide" });
  await page.unroute(`${address}lesson/styled.html`);
  return PNG.sync.read(bytes);
}

/** The page as it is on paper or on the screen, once all that it has is there. */
async function shown(page: Page, style: Style, medium: "print" | "screen", body: string): Promise<PNG> {
  const path = `${address}lesson/shown.html`;
  await page.route(path, (route) => route.fulfill({ contentType: "text/html", body: lesson(style, body) }));
  await page.goto(path);
  await page.waitForFunction(
    () => document.querySelectorAll("mo-copp-playground:not([data-status=optimal], [data-status=error])").length === 0,
  );
  await page.emulateMedia({ media: medium });
  const bytes = await page.locator("#frame").screenshot({ animations: "disabled", caret: "hide" });
  await page.emulateMedia({ media: null });
  await page.unroute(path);
  return PNG.sync.read(bytes);
}

const plain: Style = { name: "none", css: "" };

test("other people's style sheets change next to nothing of the picture", () =>
  visit(
    async ({ page }) => {
      const without = await picture(page, plain);
      const apart: string[] = [];
      for (const style of styles) {
        const { width, height, data } = await picture(page, style);
        assert.deepEqual([width, height], [without.width, without.height], style.name);
        const differ = pixelmatch(without.data, data, undefined, width, height) / (width * height);
        if (differ > MOST_APART) apart.push(`${style.name}: ${(differ * 100).toFixed(2)} %`);
      }
      assert.deepEqual(apart, []);
    },
    { viewport: { width: 1280, height: 900 }, quiet: false },
  ));

test("lines of the page's text reach neither what is printed nor a message", () =>
  visit(
    async ({ page }) => {
      const lines = styles.find(({ name }) => name.startsWith("lines")) ?? assert.fail("no such style");
      const broken = `<mo-copp-playground problem="nowhere" link="off"></mo-copp-playground>`;
      for (const [medium, body] of [
        ["print", elements],
        ["screen", broken],
      ] as const) {
        const [without, styled] = [await shown(page, plain, medium, body), await shown(page, lines, medium, body)];
        const { width, height } = without;
        assert.deepEqual([styled.width, styled.height], [width, height], medium);
        assert.equal(pixelmatch(without.data, styled.data, undefined, width, height), 0, medium);
      }
    },
    { viewport: { width: 1280, height: 900 }, quiet: false },
  ));

test("a page without a doctype changes as little, where there are tables and forms, too", () =>
  visit(
    async ({ page }) => {
      const css = "body { font: italic 700 24px/2 serif; color: red; text-align: right; white-space: pre }";
      for (const tab of ["Solve", "Steps"]) {
        const without = await picture(page, plain, tab);
        for (const style of [plain, { name: "styled", css }]) {
          const { width, height, data } = await picture(page, { ...style, doctype: "" }, tab);
          assert.equal(await page.evaluate(() => document.compatMode), "BackCompat");
          assert.deepEqual([width, height], [without.width, without.height], `${tab}, ${style.name}`);
          const differ = pixelmatch(without.data, data, undefined, width, height) / (width * height);
          assert(differ <= MOST_APART, `${tab}, ${style.name}: ${differ}`);
        }
      }
    },
    { viewport: { width: 1280, height: 900 }, quiet: false },
  ));

test("the comparison sees what a style sheet does to the page's own document", () =>
  visit(
    async ({ page }) => {
      const without = await picture(page, plain);
      // Reaches into the element by a part that the page is offered.
      const { width, height, data } = await picture(page, { name: "part", css: "::part(board) { opacity: 0 }" });
      assert.deepEqual([width, height], [without.width, without.height]);
      assert(pixelmatch(without.data, data, undefined, width, height) / (width * height) > MOST_APART);
    },
    { viewport: { width: 1280, height: 900 }, quiet: false },
  ));
