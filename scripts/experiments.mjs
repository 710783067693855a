// `npm run experiments`: the paper's experiments into docs/results/, and their tables into docs/experiments.md.
// A run that was stopped goes on where it stopped; one that is complete is only read. Remove docs/results/ to run anew.
import { inRoot } from "./lib/paths.mjs";
import { run } from "./lib/run.mjs";
import { showTables } from "./lib/tables.mjs";

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

showTables("experiments.md", figures);
console.log("The tables of docs/experiments.md are those of docs/results/.");
