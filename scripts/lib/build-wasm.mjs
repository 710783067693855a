// The Rust core, built for the browser: the full one into www/pkg, built for speed, and the light one, with which the
// page begins, into www/pkg-light, built for size. Each is four steps: cargo, wasm-bindgen, wasm-opt, and an order of the
// functions that packs well, which makes 5 % fewer bytes of them on their way. Nothing is done
// while what a package is made from has not changed: cargo would see that too, but wasm-opt would run again each time.
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { homedir } from "node:os";
import { join } from "node:path";
import { wasmTarget } from "../setup/rust.mjs";
import { filesUnder } from "./files-under.mjs";
import { withOrderedNames } from "./function-order.mjs";
import { fromRoot, inRoot, lightWasmPackage, root, tools, wasmPackage } from "./paths.mjs";
import { read, run } from "./run.mjs";

/** What every browser with module workers knows, as does rustc's default for the target. */
const features = [
  "--enable-bulk-memory",
  "--enable-nontrapping-float-to-int",
  "--enable-sign-ext",
  "--enable-mutable-globals",
  "--enable-reference-types",
  "--enable-multivalue",
];

const packages = [
  {
    name: "full wasm package",
    file: "mo_copp",
    folder: wasmPackage,
    profile: "wasm-fast",
    cargo: [],
    // A level that minds size, with these thresholds in place of its own (75 for both): what the source marks as worth inlining
    // is inlined more readily, all else less. A sixth fewer bytes, packed, than level 3 with 20 for both, and a tenth slower. What is worth
    // it has been inlined then: more of it by the optimiser costs bytes, and no time was gained.
    flags: ["-Cllvm-args=--inline-threshold=8 --inlinehint-threshold=100"],
    optimiser: ["-O2", "-ocimfs", "0", "-fimfs", "0", "--strip-producers", ...features],
  },
  {
    name: "light wasm package",
    file: "mo_copp_light",
    folder: lightWasmPackage,
    profile: "wasm-small",
    cargo: ["--no-default-features"],
    flags: [],
    optimiser: ["-Oz", "-ocimfs", "0", "-fimfs", "0", "--converge", "--strip-producers", ...features],
  },
];

/** Builds where needed, with the options of `run`; resolves to the exit code. */
export async function buildWasm(options = {}) {
  const codes = await Promise.all(packages.map((one) => buildWhereNeeded(one, options)));
  return codes.find((code) => code !== 0) ?? 0;
}

async function buildWhereNeeded(one, options) {
  const now = fingerprint(one);
  const stamp = join(tools, `${one.file}-made-from`);
  if (existsSync(wasmOf(one)) && existsSync(stamp) && readFileSync(stamp, "utf8") === now) {
    (options.output ?? ((text) => process.stdout.write(text)))(`The ${one.name} is up to date.\n`);
    return 0;
  }
  const code = await build(one, options);
  if (code !== 0) return code;
  mkdirSync(tools, { recursive: true });
  writeFileSync(stamp, now);
  return 0;
}

const wasmOf = ({ folder, file }) => join(folder, `${file}_bg.wasm`);

const cargoArgs = ({ profile, cargo }) => [
  ...["build", "--lib", "--locked", "--target", wasmTarget, "--profile", profile],
  ...cargo,
];

async function build(one, options) {
  // A folder of its own for each, so that the two are built side by side.
  const target = inRoot("target", one.profile);
  const made = join(target, wasmTarget, one.profile, "mo_copp.wasm");
  const start = (command, args, env = {}) => run(command, args, { ...options, env });
  const compiled = await start("cargo", cargoArgs(one), {
    CARGO_TARGET_DIR: target,
    CARGO_ENCODED_RUSTFLAGS: [...rustFlags(), ...one.flags].join("\x1f"),
  });
  if (compiled !== 0) return compiled;
  rmSync(one.folder, { recursive: true, force: true });
  const bind = ["--target", "web", "--out-dir", one.folder, "--out-name", one.file, made];
  const optimise = [wasmOf(one), "-o", wasmOf(one), ...one.optimiser];
  const code =
    (await start("wasm-bindgen", bind)) || (await start("wasm-opt", optimise)) || (await order(wasmOf(one), start));
  // A package that was not finished is none.
  if (code !== 0) rmSync(one.folder, { recursive: true, force: true });
  return code;
}

/** Puts like functions beside each other; resolves to the exit code. */
function order(wasm, start) {
  writeFileSync(wasm, withOrderedNames(readFileSync(wasm)));
  return start("wasm-opt", [wasm, "-o", wasm, "--reorder-functions-by-name", "--strip-debug", ...features]);
}

/** The flags of the environment, and names for the folders of this machine: panics name their place in the sources. */
function rustFlags() {
  const cargoHome = process.env.CARGO_HOME ?? join(homedir(), ".cargo");
  const names = [
    [homedir(), "home"],
    [join(cargoHome, "registry", "src"), "crates"],
    [join(read("rustc", ["--print", "sysroot"]) ?? "", "lib", "rustlib", "src", "rust"), "rust"],
    [root, "."],
  ];
  const given = process.env.CARGO_ENCODED_RUSTFLAGS?.split("\x1f") ?? process.env.RUSTFLAGS?.split(/\s+/) ?? [];
  // The last that fits is taken, so the narrower ones come later.
  return [...given.filter(Boolean), ...names.map(([folder, name]) => `--remap-path-prefix=${folder}=${name}`)];
}

function fingerprint(one) {
  const hash = createHash("sha256");
  const versions = ["rustc", "wasm-bindgen", "wasm-opt"].map((command) => read(command, ["--version"]));
  hash.update(JSON.stringify([cargoArgs(one), one.flags, one.optimiser, versions]));
  const made = ["function-order.mjs", "wasm-sections.mjs"].map((name) => inRoot("scripts", "lib", name));
  for (const file of [inRoot("Cargo.toml"), inRoot("Cargo.lock"), ...made, ...filesUnder(inRoot("src"))]) {
    hash.update(`\0${fromRoot(file)}\0`).update(readFileSync(file));
  }
  return hash.digest("hex");
}
