// `npm run experiments`: the paper's experiments into docs/results/, and their tables into docs/experiments.md.
// A run that was stopped goes on where it stopped; one that is complete is only read. Remove docs/results/ to run anew.
import { readFileSync, writeFileSync } from "node:fs";
import { inRoot } from "./lib/paths.mjs";
import { run } from "./lib/run.mjs";

const folder = (figure) => inRoot("docs", "results", figure);

const build = ["cargo", ["build", "--release", "--bin", "mo-copp"]];
const figures = ["fig3", "fig4"];
const runs = figures.map((figure) => [
  inRoot("target", "release", "mo-copp"),
  ["experiment", figure, "--out", folder(figure)],
]);

for (const [command, args] of [build, ...runs]) {
  const code = await run(command, args);
  if (code !== 0) process.exit(code);
}

const document = inRoot("docs", "experiments.md");
let text = readFileSync(document, "utf8");
for (const figure of figures) {
  const [begin, end] = [`<!-- tables of ${figure} -->\n`, `<!-- end of tables of ${figure} -->\n`];
  const [before, rest] = text.split(begin);
  const after = rest?.split(end)[1];
  if (after === undefined) throw new Error(`docs/experiments.md has no ${begin.trim()} … ${end.trim()}`);
  const tables = readFileSync(inRoot("docs", "results", figure, "tables.md"), "utf8");
  text = `${before}${begin}\n${tables}\n${end}${after}`;
}
writeFileSync(document, text);
console.log("The tables of docs/experiments.md are those of docs/results/.");
