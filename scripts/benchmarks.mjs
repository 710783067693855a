// `npm run benchmarks -- FOLDER`: solvers on the goal-recognition problems below FOLDER into docs/results/benchmarks/, and their
// tables into docs/benchmarks.md. A run that was stopped goes on; with `--anew` after FOLDER all is run again.

import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { resolve } from "node:path";
import { inRoot } from "./lib/paths.mjs";
import { run } from "./lib/run.mjs";
import { showTables } from "./lib/tables.mjs";

const [folder, anew] = process.argv.slice(2);
if (folder === undefined || (anew !== undefined && anew !== "--anew")) {
  console.error("expected npm run benchmarks -- FOLDER [--anew]");
  process.exit(2);
}

const name = "benchmarks";
if (anew) rmSync(inRoot("docs", "results", name), { recursive: true, force: true });
const steps = [
  ["cargo", ["build", "--release", "--bin", "mo-copp"]],
  [
    inRoot("target", "release", "mo-copp"),
    ["experiment", name, resolve(folder), "--out", inRoot("docs", "results", name)],
  ],
];
for (const [command, args] of steps) {
  const code = await run(command, args);
  if (code !== 0) process.exit(code);
}

// What depends on the clock says where and when, and what else the machine did.
const tables = inRoot("docs", "results", name, "tables.md");
const [cpu] = cpus();
const day = new Date().toISOString().slice(0, 10);
const machine = `${cpus().length} cores of ${cpu.model.trim()}`;
const load = `load average of its last 15 minutes ${loadavg()[2].toFixed(1)}`;
const where = `Measured on ${day}, release build, one problem at a time, on ${machine} (${load}).\n\n`;
writeFileSync(tables, where + readFileSync(tables, "utf8"));
showTables("benchmarks.md", [name]);
console.log("The tables of docs/benchmarks.md are those of docs/results/benchmarks/.");
