// The Rust core, built for the browser into www/pkg. Nothing is done while what it is made from has not changed:
// cargo would see that too, but wasm-opt would run again each time.
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { inRoot, root, tools, wasmPackage } from "./paths.mjs";
import { read, run } from "./run.mjs";

const args = [
  "build",
  ...["--target", "web", "--out-dir", relative(root, wasmPackage), "--profile", "wasm-release"],
  // What wasm-pack writes for publishing (its .gitignore too) would only be in the way.
  ...["--no-pack", "--no-gitignore"],
  // Every tool is there by now; this one must not fetch its own.
  ...["--mode", "no-install"],
];
const stamp = join(tools, "wasm-made-from");

/** Builds where needed; resolves to the exit code. */
export async function buildWasm() {
  const now = fingerprint();
  const built = join(wasmPackage, "mo_copp_bg.wasm");
  if (existsSync(built) && existsSync(stamp) && readFileSync(stamp, "utf8") === now) {
    console.log("The wasm package is up to date.");
    return 0;
  }
  rmSync(wasmPackage, { recursive: true, force: true });
  const code = await run("wasm-pack", args);
  if (code !== 0) return code;
  mkdirSync(tools, { recursive: true });
  writeFileSync(stamp, now);
  return 0;
}

function fingerprint() {
  const hash = createHash("sha256");
  hash.update(JSON.stringify([args, read("rustc", ["--version"]), read("wasm-pack", ["--version"])]));
  for (const file of [inRoot("Cargo.toml"), inRoot("Cargo.lock"), ...filesUnder(inRoot("src"))]) {
    hash.update(`\0${relative(root, file)}\0`).update(readFileSync(file));
  }
  return hash.digest("hex");
}

const filesUnder = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
    .sort();
