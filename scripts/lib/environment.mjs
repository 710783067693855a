// The environment that child commands get: the project's own tools first on PATH, then the machine's.
import { accessSync, constants, existsSync, statSync } from "node:fs";
import { homedir } from "node:os";
import { delimiter, isAbsolute, join } from "node:path";
import { nodeModules, toolsBin } from "./paths.mjs";

const cargoHome = process.env.CARGO_HOME ?? join(homedir(), ".cargo");

/** PATH for child commands. `~/.cargo/bin` comes last: it only helps a shell that has not read rustup's profile yet. */
export function searchPath() {
  const own = [toolsBin, join(nodeModules, ".bin")];
  const machine = (process.env.PATH ?? "").split(delimiter).filter((folder) => folder !== "" && !own.includes(folder));
  return [...own, ...machine, join(cargoHome, "bin")];
}

export function childEnvironment(extra = {}) {
  return { ...process.env, PATH: searchPath().join(delimiter), ...extra };
}

/** The full path of a command, or null where there is none. */
export function which(command) {
  const candidates = isAbsolute(command) ? [command] : searchPath().map((folder) => join(folder, command));
  return candidates.find(isExecutable) ?? null;
}

function isExecutable(file) {
  if (!existsSync(file) || !statSync(file).isFile()) return false;
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}
