// The Rust core, built for the browser: the full one into www/pkg, and the light one, with which the page begins, into
// www/pkg-light. Nothing is done while what they are made from has not changed: cargo would see that too, but wasm-opt
// would run again each time.
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { inRoot, lightWasmPackage, root, tools, wasmPackage } from "./paths.mjs";
import { read, run } from "./run.mjs";

const packages = [
  { name: "full wasm package", file: "mo_copp", folder: wasmPackage, stamp: "wasm-made-from", cargo: [], env: {} },
  {
    name: "light wasm package",
    file: "mo_copp_light",
    folder: lightWasmPackage,
    stamp: "light-wasm-made-from",
    cargo: ["--no-default-features"],
    // A folder of its own, so that the two are built side by side.
    env: { CARGO_TARGET_DIR: inRoot("target", "light") },
  },
];

const argsOf = ({ file, folder, cargo }) => [
  "build",
  ...["--target", "web", "--out-dir", relative(root, folder), "--out-name", file, "--profile", "wasm-release"],
  // What wasm-pack writes for publishing (its .gitignore too) would only be in the way.
  ...["--no-pack", "--no-gitignore"],
  // Every tool is there by now; this one must not fetch its own.
  ...["--mode", "no-install"],
  ...(cargo.length > 0 ? ["--", ...cargo] : []),
];

/** Builds where needed; resolves to the exit code. */
export async function buildWasm() {
  const codes = await Promise.all(packages.map(buildOne));
  return codes.find((code) => code !== 0) ?? 0;
}

async function buildOne(one) {
  const now = fingerprint(one);
  const stamp = join(tools, one.stamp);
  const built = join(one.folder, `${one.file}_bg.wasm`);
  if (existsSync(built) && existsSync(stamp) && readFileSync(stamp, "utf8") === now) {
    console.log(`The ${one.name} is up to date.`);
    return 0;
  }
  rmSync(one.folder, { recursive: true, force: true });
  const code = await run("wasm-pack", argsOf(one), { env: one.env });
  if (code !== 0) return code;
  mkdirSync(tools, { recursive: true });
  writeFileSync(stamp, now);
  return 0;
}

function fingerprint(one) {
  const hash = createHash("sha256");
  hash.update(JSON.stringify([argsOf(one), read("rustc", ["--version"]), read("wasm-pack", ["--version"])]));
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
