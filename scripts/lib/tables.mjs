// Tables that a document of docs/ shows, as results in a folder have them.
import { readFileSync, writeFileSync } from "node:fs";
import { inRoot } from "./paths.mjs";

/** Puts `docs/results/NAME/tables.md` between the two comments that name it, for each name. */
export function showTables(document, names) {
  const path = inRoot("docs", document);
  let text = readFileSync(path, "utf8");
  for (const name of names) {
    const [begin, end] = [`<!-- tables of ${name} -->\n`, `<!-- end of tables of ${name} -->\n`];
    const [before, rest] = text.split(begin);
    const after = rest?.split(end)[1];
    if (after === undefined) throw new Error(`docs/${document} has no ${begin.trim()} … ${end.trim()}`);
    const tables = readFileSync(inRoot("docs", "results", name, "tables.md"), "utf8");
    text = `${before}${begin}\n${tables}\n${end}${after}`;
  }
  writeFileSync(path, text);
}
