// The core in Node, for what the article shows: its wasm package must have been built.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import init, { Problem } from "../../www/pkg/mo_copp.js";
import { wasmPackage } from "../lib/paths.mjs";

await init({ module_or_path: readFileSync(join(wasmPackage, "mo_copp_bg.wasm")) });

export { Problem };
