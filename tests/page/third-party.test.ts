// What the built site owes to others: their licences and notices; and to its builder: no paths of the machine.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { homedir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { dist, inRoot, root } from "../../scripts/lib/paths.mjs";
import { read } from "../../scripts/lib/run.mjs";
import { written } from "../../scripts/third-party/plugin.mjs";
import { visit } from "./support/browser.js";

const notices = readFileSync(join(dist, "THIRD-PARTY.txt"), "utf8");

interface Dependency {
  name: string;
  kind: string | null;
  target: string | null;
}

/** The lines of a package, by its name. */
const entryOf = (name: string) =>
  notices.split("\n\n").find((part) => part.startsWith(`${name} `) && part.includes("\n  licence: "));

test("every package of the page and every crate of the core is named with its licence and its texts", () => {
  const { dependencies } = JSON.parse(readFileSync(inRoot("package.json"), "utf8"));
  const own = JSON.parse(read("cargo", ["metadata", "--no-deps", "--format-version", "1"]) ?? "").packages[0];
  const direct: string[] = own.dependencies
    .filter(({ kind, target }: Dependency) => kind === null && !(target ?? "").includes("not("))
    .map(({ name }: Dependency) => name);
  assert(direct.includes("microlp") && direct.includes("wasm-bindgen"), direct.join());
  // What they are made of in their turn.
  const indirect = ["lzma1", "lit-html", "@lit/reactive-element", "@lezer/common", "ndarray", "serde_core"];
  for (const name of [...Object.keys(dependencies), ...direct, ...indirect, "The Rust standard library"]) {
    const entry = entryOf(name) ?? assert.fail(`no word of ${name}`);
    assert.match(entry, /\n {2}licence: [A-Z]/, name);
    assert.match(entry, /\n {2}texts: \d/, name);
  }
  assert(!notices.includes("the package comes with none"));
  assert.match(notices, /Permission is hereby granted, free of charge/);
  assert.match(notices, /Copyright .*Google LLC/);
  // What only builds or tests is in no file of the site.
  for (const name of ["vite", "playwright-core", "proptest", "clap", "serde_derive"]) {
    assert.equal(entryOf(name), undefined, name);
  }
});

test("a text that many packages come with is written once", () => {
  const one = { version: "1", licence: "MIT", from: undefined, authors: [] };
  const text = written([
    { ...one, name: "a", notices: ["shared"] },
    { ...one, name: "b", notices: ["own", "shared"] },
    { ...one, name: "c", notices: [] },
  ]);
  assert.equal(text.split("shared").length, 2);
  assert.match(text, /a 1\n {2}licence: MIT\n {2}texts: 1\n\nb 1\n {2}licence: MIT\n {2}texts: 2, 1\n/);
  assert.match(text, /c 1\n {2}licence: MIT\n {2}texts: the package comes with none/);
});

test("the footer leads to them", () =>
  visit(async ({ page }) => {
    const link = page.getByRole("contentinfo").getByRole("link", { name: "packages that others wrote" });
    const answer = await page.request.get(await link.evaluate((anchor) => (anchor as HTMLAnchorElement).href));
    assert.equal(answer.status(), 200);
    assert.match(answer.headers()["content-type"] ?? "", /^text\/plain/);
    assert.equal(await answer.text(), notices);
  }));

test("no file of the site names a folder of the machine that built it", () => {
  const folders = [root, homedir(), process.env.CARGO_HOME ?? join(homedir(), ".cargo")].filter((path) => path !== "/");
  const files = readdirSync(dist, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  assert(files.some(({ name }) => name.endsWith(".wasm")));
  for (const file of files) {
    const content = readFileSync(join(file.parentPath ?? file.path, file.name));
    for (const path of [...folders, "/.cargo/registry/", "/rustlib/src/rust/"]) {
      assert.equal(content.indexOf(path), -1, `${file.name} holds ${path}`);
    }
  }
});
