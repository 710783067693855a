// Installing a Rust program into the project's own .tools/ folder, which is first on PATH for our commands.
import { tools } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";
import { SetupError, say } from "./report.mjs";

export async function cargoInstall(crate, version, flags = []) {
  say(crate, `installing ${version} into .tools (takes a few minutes, once)`);
  const args = ["install", crate, "--version", version, "--root", tools, "--quiet", ...flags];
  if ((await run("cargo", args)) !== 0) {
    throw new SetupError(`${crate} ${version} could not be installed.`, `cargo ${args.join(" ")}`);
  }
}
