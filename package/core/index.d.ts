import type { Problem as LoadedProblem, Outcome, Run, SolveOptions } from "./mo_copp.js";

export type * from "./mo_copp.js";

/** A type of the browser or of Node, where the program has it: these types need neither. */
type OfGlobal<Name extends string> =
  typeof globalThis extends Record<Name, { prototype: infer Instance }> ? Instance : never;
type WebAssemblyModule = typeof globalThis extends { WebAssembly: { Module: { prototype: infer Module } } }
  ? Module & object
  : never;

/** The bytes of the solver, compiled or not, or where they are. */
export type WasmSource =
  | string
  | ArrayBuffer
  | ArrayBufferView
  | OfGlobal<"URL">
  | OfGlobal<"Request">
  | OfGlobal<"Response">
  | WebAssemblyModule;

/** What a solver is asked; without `solver` it is exact search. */
export type Options = Omit<SolveOptions, "solver"> & Partial<Pick<SolveOptions, "solver">>;

/** A problem made of a document. `load` comes before. */
export declare class Problem extends LoadedProblem {
  /** Reads a document of any format, given as an object or as its text. Throws a `DocumentError` that names the place. */
  constructor(document: object | string);
  /** Gets a solver ready. Throws an `OptionsError` where the options do not fit. */
  solve(options?: Options): Run;
}

/** Loads the solver, once. `wasm`: its bytes or where they are; by default the file of the package. */
export declare function load(wasm?: WasmSource | Promise<WasmSource>): Promise<void>;

/**
 * Solves a problem document, given as an object or as its text, to the end.
 * Rejects with an error that names the place in the document, or the option, that is wrong.
 */
export declare function solve(document: object | string, options?: Options): Promise<Outcome>;
