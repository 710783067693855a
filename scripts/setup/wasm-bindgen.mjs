// wasm-bindgen's command must be of exactly the version of the wasm-bindgen crate in Cargo.lock;
// with any other, wasm-pack would look for a download elsewhere.
import { readFileSync } from "node:fs";
import { inRoot } from "../lib/paths.mjs";
import { read } from "../lib/run.mjs";
import { cargoInstall } from "./cargo-install.mjs";
import { SetupError, say } from "./report.mjs";
import { versionIn } from "./version.mjs";

export async function ensureWasmBindgen() {
  const wanted = lockedVersion();
  const commands = ["wasm-bindgen", "wasm-bindgen-test-runner"];
  const found = commands.map((command) => versionIn(read(command, ["--version"])));
  if (found.every((version) => version === wanted)) return say("wasm-bindgen", wanted);
  // Without --locked: the lock file inside the crate can name versions that a registry does not have.
  await cargoInstall("wasm-bindgen-cli", wanted, { anotherIsThere: found.some((version) => version !== null) });
}

function lockedVersion() {
  const lock = readFileSync(inRoot("Cargo.lock"), "utf8");
  const found = /name = "wasm-bindgen"\nversion = "([^"]+)"/.exec(lock)?.[1];
  if (found === undefined) throw new SetupError("Cargo.lock names no wasm-bindgen.", "cargo generate-lockfile");
  return found;
}
