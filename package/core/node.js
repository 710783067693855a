// The solver in Node, which reads the file beside this one.
import { readFile } from "node:fs/promises";
import { loadFrom, solveLoaded } from "./load.js";

export { Problem } from "./load.js";

export const load = (wasm) => loadFrom(() => wasm ?? readFile(new URL("./mo_copp_bg.wasm", import.meta.url)));

export async function solve(document, options) {
  await load();
  return solveLoaded(document, options);
}
