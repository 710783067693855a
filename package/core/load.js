// The solver: loading its WebAssembly once, and solving with it.
import init, { Problem } from "./mo_copp.js";

export { Problem };

/** How many expansions or nodes a run takes before it looks whether it is at its end. */
const BUDGET = 10_000;

let loading;

/** Loads the solver, once. `wasm`: its bytes or where they are; by default the file beside this one. */
export function loadFrom(wasm) {
  loading ??= Promise.resolve(wasm())
    .then((source) => init({ module_or_path: source }))
    .then(
      () => undefined,
      (error) => {
        loading = undefined;
        throw error;
      },
    );
  return loading;
}

/** Solves a loaded problem document, given as an object or as its text. */
export function solveLoaded(document, options) {
  const text = typeof document === "string" ? document : JSON.stringify(document);
  if (text === undefined) throw new TypeError(`“${document}” is no problem document; expected an object or its text.`);
  const problem = new Problem(text);
  try {
    const run = problem.solve(options);
    while (!run.advance(BUDGET));
    const outcome = run.outcome();
    run.free();
    return outcome;
  } finally {
    problem.free();
  }
}
