// Running other programs: with their output shown, or read.
import { spawn, spawnSync } from "node:child_process";
import { childEnvironment } from "./environment.mjs";
import { root } from "./paths.mjs";

/** Runs a program with its output shown; resolves to its exit code (1 when it cannot be started or is killed). */
export function run(command, args, { env = {} } = {}) {
  return new Promise((resolve) => {
    const child = spawn(command, args, {
      cwd: root,
      env: childEnvironment(env),
      stdio: ["ignore", "inherit", "inherit"],
    });
    child.on("error", (error) => {
      console.error(`${command}: ${error.message}`);
      resolve(1);
    });
    child.on("close", (code) => resolve(code ?? 1));
  });
}

/** Runs a short program and returns what it printed, trimmed; null when it failed or is not there. */
export function read(command, args) {
  const result = spawnSync(command, args, {
    cwd: root,
    env: childEnvironment(),
    encoding: "utf8",
    stdio: ["ignore", "pipe", "ignore"],
  });
  return result.status === 0 ? result.stdout.trim() : null;
}
