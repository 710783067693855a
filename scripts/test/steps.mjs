// The checks, in the order they run.
import { buildPage } from "../lib/build-page.mjs";
import { buildWasm } from "../lib/build-wasm.mjs";
import { run } from "../lib/run.mjs";
import { venvPython } from "../setup/python-packages.mjs";
import { wasmTarget } from "../setup/rust.mjs";
import { browserTests } from "./browser-tests.mjs";
import { kitTests } from "./kit-tests.mjs";
import { pageTests } from "./page-tests.mjs";

/** The groups of checks, and what set-up each needs. */
export const groups = {
  lint: ["lint"],
  rust: ["rust"],
  wasm: ["wasm"],
  page: ["browser"],
  kits: ["browser"],
  browsers: ["browsers"],
  fuzz: ["fuzz"],
};

const program =
  (command, args, env = {}) =>
  (options) =>
    run(command, args, { ...options, env });
const cargo = (args, env) => program("cargo", args, env);
const clippy = (...args) => cargo(["clippy", ...args, "--", "-D", "warnings"]);
const pythons = {
  MO_COPP_HIGHS_PYTHON: venvPython,
  MO_COPP_PYPERPLAN_PYTHON: venvPython,
  MO_COPP_JSONSCHEMA_PYTHON: venvPython,
};
const wasmRunner = { CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: "wasm-bindgen-test-runner" };

/** Cargo lets one command at a time into its folder; everything else is beside it. */
const [RUST, PAGE] = ["rust", "page"];

/** A step: its name, its groups, its lane, the steps it can't do without, and how it runs (to an exit code). */
export const steps = [
  { name: "Rust format", groups: ["lint"], lane: RUST, run: cargo(["fmt", "--check"]) },
  { name: "Rust lint", groups: ["lint"], lane: RUST, run: clippy("--all-targets") },
  {
    name: "Rust lint for wasm",
    groups: ["lint"],
    lane: RUST,
    run: clippy("--target", wasmTarget, "--lib", "--test", "wasm"),
  },
  {
    name: "Rust lint for the light wasm",
    groups: ["lint"],
    lane: RUST,
    run: clippy("--target", wasmTarget, "--lib", "--no-default-features"),
  },
  {
    name: "Rust documentation",
    groups: ["lint"],
    lane: RUST,
    run: cargo(["doc", "--no-deps"], { RUSTDOCFLAGS: "-D warnings" }),
  },
  { name: "Rust tests", groups: ["rust"], lane: RUST, run: cargo(["test"], pythons) },
  {
    name: "Fuzzing, a minute",
    groups: ["fuzz"],
    lane: RUST,
    run: cargo(["test", "--test", "fuzz", "--", "--seconds", "60"]),
  },
  {
    name: "wasm tests in Node",
    groups: ["wasm"],
    lane: RUST,
    run: cargo(["test", "--target", wasmTarget, "--profile", "wasm-test", "--test", "wasm"], wasmRunner),
  },
  { name: "wasm packages", groups: ["lint", "page", "kits", "browsers"], lane: PAGE, run: buildWasm },
  // The page's types come from the wasm package.
  {
    name: "TypeScript types",
    groups: ["lint"],
    lane: PAGE,
    needs: ["wasm packages"],
    run: program("tsc", ["--noEmit"]),
  },
  { name: "TypeScript lint", groups: ["lint"], lane: PAGE, run: program("biome", ["check", "--error-on-warnings"]) },
  {
    name: "Workflows",
    groups: ["lint"],
    lane: PAGE,
    run: program(process.execPath, ["scripts/test/workflows.mjs"]),
  },
  {
    name: "List of files",
    groups: ["lint"],
    lane: PAGE,
    run: program(process.execPath, ["scripts/files.mjs", "--check"]),
  },
  { name: "Page build", groups: ["page", "kits", "browsers"], lane: PAGE, needs: ["wasm packages"], run: buildPage },
  { name: "Page tests in Chromium", groups: ["page"], lane: PAGE, needs: ["Page build"], run: pageTests },
  { name: "Author kits", groups: ["kits"], lane: PAGE, needs: ["Page build"], run: kitTests },
  {
    name: "The page in Chromium, Firefox and WebKit",
    groups: ["browsers"],
    lane: PAGE,
    needs: ["Page build"],
    run: browserTests,
  },
];
