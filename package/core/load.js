// The solver: loading its WebAssembly once, and solving with it.
import init, { Problem as LoadedProblem } from "./mo_copp.js";

/** How many expansions or nodes a run takes before it looks whether it is at its end. */
const BUDGET = 10_000;

let loading;
let loaded = false;

/** Loads the solver, once. `wasm`: its bytes or where they are; by default the file beside this one. */
export function loadFrom(wasm) {
  loading ??= Promise.resolve(wasm())
    .then((source) => init({ module_or_path: source }))
    .then(
      () => {
        loaded = true;
      },
      (error) => {
        loading = undefined;
        throw error;
      },
    );
  return loading;
}

/** A problem made of a document, which may be an object or its text. */
export class Problem extends LoadedProblem {
  constructor(document) {
    super(textOf(document));
  }

  solve(options) {
    return super.solve(withSolver(options));
  }
}

/** Solves a problem document to the end, once the solver is loaded. */
export function solveLoaded(document, options) {
  const problem = new Problem(document);
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

/** What the solver reads; throws a sentence for what it cannot be given. */
function textOf(document) {
  if (!loaded) throw new Error("The solver is not loaded yet; expected “await load()” before “new Problem(…)”.");
  if (typeof document === "string") return document;
  const refused = (found) => new TypeError(`${found} is no problem document; expected an object or its text.`);
  let text;
  try {
    text = JSON.stringify(document);
  } catch {
    throw refused("What is no JSON (as an object that holds itself, or a BigInt)");
  }
  if (text === undefined) throw refused(`“${String(document)}”`);
  return text;
}

/** Options that name no solver are for exact search. */
function withSolver(options) {
  if (options === undefined || options === null) return { solver: "exact" };
  if (typeof options !== "object" || Array.isArray(options)) return options;
  return { ...options, solver: options.solver ?? "exact" };
}
