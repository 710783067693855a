// wasm-opt makes the built wasm smaller and faster. It comes with the npm package binaryen;
// wasm-pack takes it from PATH and would look for a download otherwise.
import { which } from "../lib/environment.mjs";
import { SetupError, say } from "./report.mjs";

export async function ensureWasmOpt() {
  if (which("wasm-opt") === null) throw new SetupError("wasm-opt was not found among the npm packages.", "npm ci");
  say("wasm-opt", "from the npm package binaryen");
}
