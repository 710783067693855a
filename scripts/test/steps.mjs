// The checks, in the order they run.
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { buildPage } from "../lib/build-page.mjs";
import { buildWasm } from "../lib/build-wasm.mjs";
import { inRoot } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";
import { venvPython } from "../setup/python-packages.mjs";
import { wasmTarget } from "../setup/rust.mjs";

/** The groups of checks, and what set-up each needs. */
export const groups = { lint: ["lint"], rust: ["rust"], wasm: ["wasm"], page: ["browser"] };

const cargo = (args, env) => () => run("cargo", args, { env });
const pythons = { MO_COPP_HIGHS_PYTHON: venvPython, MO_COPP_PYPERPLAN_PYTHON: venvPython };
const wasmCrate = ["--target", wasmTarget, "--lib", "--test", "wasm"];
const lightCrate = ["--target", wasmTarget, "--lib", "--no-default-features"];

/** A step: its name, the groups it is in, the steps it can't do without, and how it runs (to an exit code). */
export const steps = [
  { name: "Rust format", groups: ["lint"], run: cargo(["fmt", "--check"]) },
  { name: "Rust lint", groups: ["lint"], run: cargo(["clippy", "--all-targets", "--", "-D", "warnings"]) },
  { name: "Rust lint for wasm", groups: ["lint"], run: cargo(["clippy", ...wasmCrate, "--", "-D", "warnings"]) },
  {
    name: "Rust lint for the light wasm",
    groups: ["lint"],
    run: cargo(["clippy", ...lightCrate, "--", "-D", "warnings"]),
  },
  { name: "Rust documentation", groups: ["lint"], run: cargo(["doc", "--no-deps"], { RUSTDOCFLAGS: "-D warnings" }) },
  { name: "Rust tests", groups: ["rust"], run: cargo(["test"], pythons) },
  // Release: a debug build of the solver can overflow the wasm stack, and it is what the page runs.
  {
    name: "wasm tests in Node",
    groups: ["wasm"],
    run: () => run("wasm-pack", ["test", "--node", "--release", "--mode", "no-install", ".", "--test", "wasm"]),
  },
  { name: "wasm packages", groups: ["lint", "page"], run: buildWasm },
  // The page's types come from the wasm package.
  { name: "TypeScript types", groups: ["lint"], needs: ["wasm packages"], run: () => run("tsc", ["--noEmit"]) },
  { name: "TypeScript lint", groups: ["lint"], run: () => run("biome", ["check", "--error-on-warnings"]) },
  { name: "Page build", groups: ["page"], needs: ["wasm packages"], run: buildPage },
  { name: "Page tests in Chromium", groups: ["page"], needs: ["Page build"], run: pageTests },
];

/** A page's test waits for what it expects, for at most 30 seconds; this ends a file that hangs all the same. */
const LIMIT_MS = 600_000;

function pageTests() {
  const folder = inRoot("tests", "page");
  const files = readdirSync(folder)
    .filter((file) => file.endsWith(".test.ts"))
    .sort();
  const options = [
    "--import",
    "tsx",
    "--test",
    "--test-reporter=spec",
    "--test-force-exit",
    "--disable-warning=ExperimentalWarning",
    `--test-timeout=${LIMIT_MS}`,
  ];
  return run(process.execPath, [...options, ...files.map((file) => join(folder, file))]);
}
