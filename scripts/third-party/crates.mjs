// The crates that are in the built wasm, with their licences and notices, by `cargo metadata` from Cargo.lock.
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { childEnvironment } from "../lib/environment.mjs";
import { root } from "../lib/paths.mjs";
import { read } from "../lib/run.mjs";
import { wasmTarget } from "../setup/rust.mjs";
import { noticesIn } from "./notices.mjs";

/** Entries of crates, in the order of their names, with Rust's own library. */
export function crates() {
  const { packages, resolve } = metadata();
  const byId = new Map(packages.map((one) => [one.id, one]));
  const nodes = new Map(resolve.nodes.map((node) => [node.id, node]));
  const met = new Set();
  const open = [resolve.root];
  while (open.length > 0) {
    const id = open.pop();
    if (met.has(id)) continue;
    met.add(id);
    for (const { pkg, dep_kinds } of nodes.get(id).deps) {
      // What only builds or tests is in no wasm; nor are macros, which run in the compiler.
      const linked = dep_kinds.some(({ kind }) => kind === null);
      const macro = byId.get(pkg).targets.some(({ kind }) => kind.includes("proc-macro"));
      if (linked && !macro) open.push(pkg);
    }
  }
  met.delete(resolve.root);
  return [standardLibrary(), ...[...met].map((id) => entry(byId.get(id))).sort(byName)];
}

const byName = (one, other) => (one.name < other.name ? -1 : 1);

function metadata() {
  const args = ["metadata", "--format-version", "1", "--locked", "--filter-platform", wasmTarget];
  const { status, stdout, stderr } = spawnSync("cargo", args, {
    cwd: root,
    env: childEnvironment(),
    encoding: "utf8",
    maxBuffer: 1 << 26,
  });
  if (status !== 0) throw new Error(`cargo metadata failed: ${stderr}`);
  return JSON.parse(stdout);
}

const entry = ({ name, version, license, authors, repository, manifest_path }) => ({
  name,
  version,
  licence: license,
  from: repository,
  authors,
  notices: noticesIn(dirname(manifest_path)),
});

function standardLibrary() {
  const [, version] = read("rustc", ["--version"])?.split(" ") ?? [];
  const folder = join(read("rustc", ["--print", "sysroot"]) ?? "", "share", "doc", "rust", "licenses");
  return {
    name: "The Rust standard library",
    version,
    licence: "MIT OR Apache-2.0",
    from: "https://github.com/rust-lang/rust",
    authors: ["The Rust Project contributors"],
    notices: noticesIn(folder, /^MIT/).length > 0 ? noticesIn(folder, /^MIT/) : [mit()],
  };
}

/** The text of the licence, where the compiler came without: it is that of this project, which names its own holder. */
const mit = () => {
  const text = readFileSync(join(root, "LICENSE-MIT"), "utf8");
  return text.slice(text.indexOf("Permission is hereby granted"));
};
