// Times the solvers in wasm under Node, on the problems of the first lines of `cargo bench`:
//   node benches/node.mjs
// Needs what `npm run setup` installs and `cargo build --release` (for the problems).
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const path = `${join(root, "node_modules/.bin")}:${join(root, ".tools/bin")}:${process.env.PATH}`;
const run = (command, ...args) =>
  execFileSync(command, args, {
    cwd: root,
    env: { ...process.env, PATH: path },
    encoding: "utf8",
    stdio: ["ignore", "pipe", "ignore"],
  });

run("wasm-pack", "build", "--target", "nodejs", "--out-dir", "target/node", "--profile", "wasm-release");
const { Problem } = createRequire(import.meta.url)(join(root, "target/node/mo_copp.js"));

const generate = (seed, ...size) =>
  run("target/release/mo-copp", "generate", "gridworld", "--seed", String(seed), ...size);

function answer(problem, options) {
  const begin = performance.now();
  const solving = problem.solve(options);
  while (!solving.advance(64)) {}
  const outcome = solving.outcome();
  solving.free();
  return { status: outcome.status, milliseconds: performance.now() - begin };
}

// The first problems that have a plan at one of two horizons, as in benches/solvers.rs.
function atHorizon(count, horizons, ...size) {
  const found = [];
  for (let seed = 0; found.length < count; seed++) {
    const problem = new Problem(generate(seed, ...size));
    const horizon = horizons.find((T) => answer(problem, { solver: "exact", horizon: T }).status === "optimal");
    if (horizon !== undefined) found.push({ problem, horizon });
  }
  return found;
}

const median = (times) => times.slice().sort((a, b) => a - b)[Math.floor(times.length / 2)];

function line(name, repeats, problems, options) {
  const times = [];
  const statuses = new Set();
  for (const { problem, horizon } of problems) {
    const runs = [];
    for (let i = 0; i < repeats; i++) {
      const { status, milliseconds } = answer(problem, options(horizon));
      runs.push(milliseconds);
      statuses.add(status);
    }
    times.push(median(runs));
  }
  console.log(
    `${name.padEnd(34)} ${median(times).toFixed(3).padStart(11)} ms ${Math.max(...times)
      .toFixed(3)
      .padStart(11)} ms   ${[...statuses]}`,
  );
}

console.log(`${"work".padEnd(34)} ${"median".padStart(14)} ${"worst".padStart(14)}`);
const eight = atHorizon(30, [12, 14]);
line("exact, 8x8, T = 12 or 14", 21, eight, (horizon) => ({ solver: "exact", horizon }));
line("exact, 8x8, all horizons", 21, eight, () => ({ solver: "exact", horizon: "any" }));
line("belief-flow, 8x8, T = 12 or 14", 3, eight, (horizon) => ({ solver: "ip", horizon }));
line("search, 8x8, k = 2, j = 2", 5, eight, () => ({ solver: "search", k: 2, j: 2 }));
const four = atHorizon(10, [6], "--width", "4", "--height", "4", "--belief", "4");
line("paper, 4x4, T = 6", 1, four, (horizon) => ({ solver: "ip", encoding: "paper", horizon }));
