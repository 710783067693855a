import type { InitInput, Outcome, SolveOptions } from "./mo_copp.js";

export type * from "./mo_copp.js";
export { Problem } from "./mo_copp.js";

/** Loads the solver, once. `wasm`: its bytes or where they are; by default the file of the package. */
export declare function load(wasm?: InitInput): Promise<void>;

/**
 * Solves a problem document, given as an object or as its text, to the end.
 * Rejects with an error that names the place in the document, or the option, that is wrong.
 */
export declare function solve(document: object | string, options?: SolveOptions): Promise<Outcome>;
