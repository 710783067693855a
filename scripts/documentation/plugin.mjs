// What the page's footer leads to: the documents of docs/ as pages, with their pictures and results, and the licences.
import { readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { inRoot } from "../lib/paths.mjs";
import { page, pages } from "./render.mjs";

const styles = [inRoot("www", "src", "style", "colours.css"), inRoot("scripts", "documentation", "documentation.css")];

/** What the documents show or offer: pictures, tables and records. */
const shown = /\.(svg|csv|json|jsonl)$/;

/** Name in the built site and content of each file. */
function files() {
  const docs = inRoot("docs");
  const beside = readdirSync(docs, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && shown.test(entry.name))
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name));
  return [
    ...pages.map(([name]) => [`docs/${name}.html`, page(name, readFileSync(join(docs, `${name}.md`), "utf8"))]),
    ...beside.map((file) => [`docs/${relative(docs, file)}`, readFileSync(file)]),
    ["docs/documentation.css", styles.map((file) => readFileSync(file, "utf8")).join("\n")],
    ["docs/LICENSE-MIT.txt", readFileSync(inRoot("LICENSE-MIT"))],
    ["docs/LICENSE-APACHE.txt", readFileSync(inRoot("LICENSE-APACHE"))],
  ];
}

/** A plugin of Vite. */
export const documentation = () => ({
  name: "documentation",
  generateBundle() {
    for (const [fileName, source] of files()) this.emitFile({ type: "asset", fileName, source });
  },
});
