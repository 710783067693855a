// The page's npm packages, exactly as package-lock.json has them.
import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { inRoot, nodeModules } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";
import { SetupError, say } from "./report.mjs";

// Which lock file node_modules was made from. File times would not do: a checkout changes them.
const stamp = join(nodeModules, ".made-from");

export async function ensureNpmPackages() {
  const lock = createHash("sha256")
    .update(readFileSync(inRoot("package-lock.json")))
    .digest("hex");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === lock) return say("npm packages", "as in package-lock.json");
  say("npm packages", "installing (npm ci)");
  const [command, ...before] = npm();
  if ((await run(command, [...before, "ci", "--no-audit", "--no-fund", "--loglevel=error"])) !== 0) {
    throw new SetupError("The npm packages could not be installed.", "npm ci");
  }
  writeFileSync(stamp, lock);
}

/** The npm that runs us, or the one on PATH. */
function npm() {
  const running = process.env.npm_execpath;
  return running?.endsWith(".js") ? [process.execPath, running] : ["npm"];
}
