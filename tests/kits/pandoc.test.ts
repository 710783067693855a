// The kit for Quarto and pandoc: its filter run by pandoc, and its shortcode as Quarto calls it.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { inRoot } from "../../scripts/lib/paths.mjs";
import { visit } from "../page/support/browser.js";
import { addPage, copyOf, kit, onePixel, python, ready, served } from "./support/site.js";

test("pandoc with Quarto's filter: HTML gets the element, LaTeX the picture or the text", () =>
  visit(async ({ page }) => {
    const folder = copyOf("quarto");
    addPage(join(folder, "mo-copp"));
    writeFileSync(join(folder, "corridor.png"), onePixel);
    const convert = (to: string, ...more: string[]) =>
      python(
        [
          "-c",
          "import pypandoc, sys; print(pypandoc.convert_file('page.md', sys.argv[1], extra_args=sys.argv[2:]))",
          to,
          "--lua-filter",
          "mo-copp.lua",
          ...more,
        ],
        folder,
      );
    const html = convert("html", "--standalone");
    assert.equal(html.match(/<script type="module"/g)?.length, 1);
    assert(!html.includes("onclick"));
    writeFileSync(join(folder, "page.html"), html);
    await page.goto(`${await served(folder)}page.html`);
    await ready(page, '[data-gd="1"]');
    // The picture stands for the playground until it runs.
    const poster = page.locator('#lab img[src="corridor.png"]');
    assert.equal(await poster.getAttribute("alt"), "The agent walks one step past the door, and back.");
    assert.equal(await poster.isVisible(), false);
    const latex = convert("latex");
    assert.match(latex, /includegraphics.*corridor\.png/);
    assert.match(latex, /\\caption\{The agent walks one step past the door, and back\.\}/);
    assert.match(latex, /Two packages from factory A\./);
    assert(!latex.includes("mo-copp-playground"));
    // Quarto loads the filter beside its own functions for shortcodes.
    writeFileSync(join(folder, "in-quarto.lua"), 'quarto = { shortcode = {} }\nreturn dofile("mo-copp.lua")');
    const inQuarto = python(
      [
        "-c",
        "import pypandoc; print(pypandoc.convert_file('page.md', 'html', extra_args=['--lua-filter', 'in-quarto.lua']))",
      ],
      folder,
    );
    assert.equal(inQuarto.match(/<mo-copp-playground /g)?.length, 2);
  }, kit));

test("Quarto's shortcode gives the same element", () => {
  // Quarto itself is not to be had here: its call is made by pandoc's Lua.
  const folder = copyOf("quarto");
  const called = (format: string) => {
    writeFileSync(
      join(folder, "call.lua"),
      `FORMAT = "${format}"
       quarto = { shortcode = {} }
       local shortcodes = dofile("mo-copp-shortcode.lua")
       local blocks = shortcodes["mo-copp"]({}, { problem = pandoc.Inlines("head-fake"), picture = pandoc.Inlines("fake.pdf"), seed = pandoc.Inlines("7"), caption = pandoc.Inlines("A \\"fake\\"") }, {})
       local text = pandoc.write(pandoc.Pandoc(blocks), FORMAT)
       function Pandoc() return pandoc.Pandoc({ pandoc.RawBlock("html", text) }) end`,
    );
    const call =
      "import pypandoc; print(pypandoc.convert_text('', 'html', format='markdown', extra_args=['--lua-filter', 'call.lua']))";
    return python(["-c", call], folder);
  };
  const html = called("html");
  assert.match(
    html,
    /<script type="module" src="mo-copp\/mo-copp-playground\.js"><\/script>\s*<mo-copp-playground problem="head-fake" seed="7">/,
  );
  // A PDF is for paper alone.
  assert(!html.includes("fake.pdf"), html);
  assert.match(html, /<\/mo-copp-playground>/);
  const latex = called("latex");
  assert.match(latex, /includegraphics.*fake\.pdf/);
  assert.match(latex, /\\caption\{A ["“`]+fake["”']+\}/);
});

test("Quarto finds in its extension a shortcode and a filter, each in a file of its own", () => {
  const extension = readFileSync(inRoot("kits", "quarto", "_extension.yml"), "utf8");
  const named = (kind: string) => new RegExp(`^  ${kind}:\\n    - (.+)$`, "m").exec(extension)?.[1] ?? "";
  const source = (file: string) => readFileSync(inRoot("kits", "quarto", file), "utf8");
  assert.match(source(named("shortcodes")), /return \{ \["mo-copp"\] = shortcode \}/);
  assert.match(source(named("filters")), /\{ Div = division \}/);
});
