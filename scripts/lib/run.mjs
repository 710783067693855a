// Running other programs: with their output shown, or read.
import { spawn, spawnSync } from "node:child_process";
import { childEnvironment } from "./environment.mjs";
import { root } from "./paths.mjs";

/**
 * Runs a program; resolves to its exit code (1 when it cannot be started or is killed). Its output is shown, or handed
 * to `output` piece by piece.
 */
export function run(command, args, { env = {}, output } = {}) {
  return new Promise((resolve) => {
    const shown = output === undefined ? "inherit" : "pipe";
    const child = spawn(command, args, { cwd: root, env: childEnvironment(env), stdio: ["ignore", shown, shown] });
    child.stdout?.on("data", output);
    child.stderr?.on("data", output);
    child.on("error", (error) => {
      if (output === undefined) console.error(`${command}: ${error.message}`);
      else output(`${command}: ${error.message}\n`);
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
