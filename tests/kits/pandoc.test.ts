// The kit for Quarto and pandoc: its filter run by pandoc, and its shortcode as Quarto calls it.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
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

/** Runs pandoc itself. */
const pandoc = (folder: string, ...args: string[]) =>
  python(
    [
      "-c",
      "import pypandoc, subprocess, sys; subprocess.run([pypandoc.get_pandoc_path(), *sys.argv[1:]], check=True)",
    ].concat(args),
    folder,
  );

test("pages and slides get the element, EPUB and other formats the picture", () => {
  const folder = copyOf("quarto");
  writeFileSync(join(folder, "corridor.png"), onePixel);
  for (const format of ["html", "html4", "html5", "revealjs", "slidy", "slideous", "dzslides", "s5"]) {
    const page = pandoc(folder, "--standalone", "--to", format, "--lua-filter", "mo-copp.lua", "page.md");
    assert.equal(page.match(/<mo-copp-playground /g)?.length, 2, format);
    assert.equal(page.match(/<script type="module"/g)?.length, 1, format);
  }
  for (const format of ["docx", "gfm", "plain", "rst", "typst"]) {
    const text = pandoc(folder, "--to", format, "--lua-filter", "mo-copp.lua", "page.md", "-o", `out.${format}`);
    assert.doesNotMatch(text + readFileSync(join(folder, `out.${format}`), "latin1"), /mo-copp-playground/, format);
  }
  // A PDF is as little for a book as for a page.
  const paper = '\n::: {.mo-copp problem="corridor" picture="corridor.pdf"}\nOn **paper** alone.\n:::\n';
  writeFileSync(join(folder, "page.md"), paper, { flag: "a" });
  for (const format of ["epub", "epub2", "epub3"]) {
    const book = pandoc(folder, "--to", format, "--lua-filter", "mo-copp.lua", "page.md", "-o", "book.epub");
    assert.equal(book, "", format);
    const chapter = python(
      [
        "-c",
        "import zipfile; b = zipfile.ZipFile('book.epub'); print(*(b.read(n).decode() for n in b.namelist() if n.endswith('html')))",
      ],
      folder,
    );
    assert.match(chapter, /<img src="[^"]+\.png"/, format);
    const words = chapter.replaceAll(/<[^>]*>/g, "").replaceAll(/\s+/g, " ");
    assert.match(words, /The agent walks one step past the door, and back\./, `${format} has the caption`);
    assert.match(chapter, /On <strong>paper<\/strong> alone/, format);
    assert.doesNotMatch(chapter, /mo-copp|<script/, format);
  }
});

test("pages in chunks have the script each", () => {
  const folder = copyOf("quarto");
  const playground = (week: number) => `# Week ${week}\n\n::: {.mo-copp problem="corridor"}\nA corridor.\n:::\n\n`;
  writeFileSync(join(folder, "weeks.md"), [1, 2].map(playground).join(""));
  pandoc(folder, "--to", "chunkedhtml", "--lua-filter", "mo-copp.lua", "-M", "title=Weeks", "-o", "site", "weeks.md");
  const weeks = readdirSync(join(folder, "site")).filter((file) => /week/.test(file));
  assert.equal(weeks.length, 2, weeks.join());
  for (const week of weeks)
    assert.match(readFileSync(join(folder, "site", week), "utf8"), /<script type="module"/, week);
});

test("a page that embeds its resources has the one script in it, and needs nothing beside it", () =>
  visit(async ({ page }) => {
    const folder = copyOf("quarto");
    addPage(join(folder, "mo-copp"));
    writeFileSync(join(folder, "corridor.png"), onePixel);
    const args = ["--standalone", "--embed-resources", "--lua-filter", "mo-copp.lua", "page.md"];
    const named = ["-M", "mo-copp-script=mo-copp/mo-copp-playground.single.js"];
    const alone = copyOf("html");
    for (const told of [["-M", "embed-resources=true"], ["-M", "self-contained=true"], named]) {
      pandoc(folder, ...told, ...args, "-o", join(alone, "alone.html"));
      await page.goto(`${await served(alone)}alone.html`);
      await ready(page, '[data-gd="1"]');
    }
    const apart = pandoc(folder, "-M", "embed-resources=false", "--lua-filter", "mo-copp.lua", "page.md");
    assert.match(apart, /src="mo-copp\/mo-copp-playground\.js"/);
  }, kit));
