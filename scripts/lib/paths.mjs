// Where things are. Every script works from any folder it is called in.
import { dirname, join, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** Tools that set-up installs for this project alone; git ignores it. */
export const tools = join(root, ".tools");
export const toolsBin = join(tools, "bin");
export const venv = join(tools, "venv");

export const nodeModules = join(root, "node_modules");
export const wasmPackage = join(root, "www", "pkg");
export const lightWasmPackage = join(root, "www", "pkg-light");
export const dist = join(root, "dist");

export const inRoot = (...parts) => join(root, ...parts);

/** A path as the documents write it: from the root on, with slashes. */
export const fromRoot = (path) => relative(root, path).split(sep).join("/");
