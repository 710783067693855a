// The solver in browsers, workers and bundlers.
import { loadFrom, solveLoaded } from "./load.js";

export { Problem } from "./load.js";

export const load = (wasm) => loadFrom(() => wasm ?? new URL("./mo_copp_bg.wasm", import.meta.url));

export async function solve(document, options) {
  await load();
  return solveLoaded(document, options);
}
