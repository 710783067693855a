// Installing a Rust program. It goes where cargo puts programs, so that it works by itself afterwards, unless another
// version of it is there: that one is left alone and ours goes into the project's own .tools/ folder, which is first on
// PATH for our commands.
import { tools } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";
import { SetupError, say } from "./report.mjs";

export async function cargoInstall(crate, version, { flags = [], anotherIsThere }) {
  const place = anotherIsThere ? ["--root", tools] : [];
  say(crate, `installing ${version}${anotherIsThere ? " into .tools" : ""} (takes a few minutes, once)`);
  const args = ["install", crate, "--version", version, "--quiet", ...place, ...flags];
  if ((await run("cargo", args)) !== 0) {
    throw new SetupError(`${crate} ${version} could not be installed.`, `cargo ${args.join(" ")}`);
  }
}
