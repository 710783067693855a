// What each kind of work needs, in the order it is looked at.
import { ensureChromium, ensureHeadlessChromium } from "./chromium.mjs";
import { ensureFirefox } from "./firefox.mjs";
import { ensureNode } from "./node.mjs";
import { ensureNpmPackages } from "./npm-packages.mjs";
import { ensureParallel } from "./parallel.mjs";
import { ensurePythonPackages } from "./python-packages.mjs";
import { SetupError } from "./report.mjs";
import { ensureRust, ensureRustLinters, ensureWasmTarget } from "./rust.mjs";
import { ensureWasmBindgen } from "./wasm-bindgen.mjs";
import { ensureWasmOpt } from "./wasm-opt.mjs";
import { ensureWasmPack } from "./wasm-pack.mjs";
import { ensureWebKit } from "./webkit.mjs";

const wasm = [ensureRust, ensureWasmTarget, ensureNpmPackages, ensureWasmPack, ensureWasmBindgen, ensureWasmOpt];

export const needs = {
  page: wasm,
  lint: [...wasm, ensureRustLinters],
  rust: [ensureRust, ensurePythonPackages, ensureParallel],
  fuzz: [ensureRust],
  wasm,
  browser: [...wasm, ensurePythonPackages, ensureChromium, ensureHeadlessChromium],
  browsers: [...wasm, ensureChromium, ensureFirefox, ensureWebKit],
};

/** Sets up what the given kinds of work need; ends the process, saying why, where that can't be done. */
export async function setUp(...kinds) {
  console.log("Set-up");
  try {
    for (const ensure of new Set([ensureNode, ...kinds.flatMap((kind) => needs[kind])])) await ensure();
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    console.error(`\nSet-up stopped: ${error.message}\nWhat helps:     ${error.remedy}`);
    process.exit(1);
  }
}
