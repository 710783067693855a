// Rust: the compiler at the version Cargo.toml asks for, its formatter and linter, a linker, and the wasm32 target.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { which } from "../lib/environment.mjs";
import { inRoot } from "../lib/paths.mjs";
import { read, run } from "../lib/run.mjs";
import { aptInstall } from "./debian.mjs";
import { SetupError, say } from "./report.mjs";
import { atLeast } from "./version.mjs";

export const wasmTarget = "wasm32-unknown-unknown";

export async function ensureRust() {
  if (which("cc") === null && !(await aptInstall("gcc", "libc6-dev"))) {
    throw new SetupError("No C linker (cc) was found; Rust needs one.", "apt-get install gcc libc6-dev   (as root)");
  }
  const version = read("rustc", ["--version"])?.split(" ")[1];
  if (version === undefined || which("cargo") === null) {
    throw new SetupError("Rust was not found.", "Install it from https://rustup.rs and run this again.");
  }
  const wanted = /^rust-version\s*=\s*"([^"]+)"/m.exec(readFileSync(inRoot("Cargo.toml"), "utf8"))?.[1] ?? "1.88";
  if (!atLeast(version, wanted)) {
    throw new SetupError(`Rust ${version} is too old; ${wanted} or later is needed.`, "rustup update stable");
  }
  say("Rust", version);
}

export async function ensureRustLinters() {
  for (const [command, component] of [
    ["cargo-fmt", "rustfmt"],
    ["cargo-clippy", "clippy"],
  ]) {
    if (read(command, ["--version"]) !== null) continue;
    say(component, "installing");
    if ((await run("rustup", ["component", "add", component])) !== 0) {
      throw new SetupError(`${component} could not be installed.`, `rustup component add ${component}`);
    }
  }
  say("Rust linters", "rustfmt, clippy");
}

export async function ensureWasmTarget() {
  if (hasWasmTarget()) return say("wasm target", wasmTarget);
  say("wasm target", `installing ${wasmTarget}`);
  if (which("rustup") !== null) await run("rustup", ["target", "add", wasmTarget]);
  if (!hasWasmTarget()) {
    throw new SetupError(`The Rust target ${wasmTarget} could not be installed.`, `rustup target add ${wasmTarget}`);
  }
}

function hasWasmTarget() {
  const folder = read("rustc", ["--print", "target-libdir", "--target", wasmTarget]);
  return folder !== null && existsSync(folder) && readdirSync(folder).some((file) => file.startsWith("libcore-"));
}
