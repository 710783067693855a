// wasm-pack builds the Rust core for the browser and runs its tests in Node.
import { read } from "../lib/run.mjs";
import { cargoInstall } from "./cargo-install.mjs";
import { say } from "./report.mjs";
import { atLeast, versionIn } from "./version.mjs";

const oldest = "0.15.0";
const tested = "0.15.1";

export async function ensureWasmPack() {
  const found = versionIn(read("wasm-pack", ["--version"]));
  if (found !== null && atLeast(found, oldest)) return say("wasm-pack", found);
  await cargoInstall("wasm-pack", tested, { flags: ["--locked"], anotherIsThere: found !== null });
}
