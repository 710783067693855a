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

if (!process.env.MO_COPP_NODE_BUILT)
  run("wasm-pack", "build", "--target", "nodejs", "--out-dir", "target/node", "--profile", "wasm-release");
const { Problem } = createRequire(import.meta.url)(join(root, "target/node/mo_copp.js"));

const generate = (seed, ...size) =>
  run("target/release/mo-copp", "generate", "gridworld", "--seed", String(seed), ...size);

function answer(problem, options, budget = Infinity) {
  const begin = performance.now();
  const solving = problem.solve(options);
  for (let done = 0; !solving.advance(64) && done < budget; done += 64);
  const outcome = solving.outcome();
  solving.free();
  return { status: outcome.status, outcome, milliseconds: performance.now() - begin };
}

// The first problems that have a plan at one of two horizons, as in benches/solvers.rs.
function atHorizon(count, horizons, ...size) {
  const found = [];
  for (let seed = 0; found.length < count; seed++) {
    const text = generate(seed, ...size);
    const problem = new Problem(text);
    const horizon = horizons.find((T) => answer(problem, { solver: "exact", horizon: T }).status === "optimal");
    if (horizon !== undefined) found.push({ text, problem, horizon });
  }
  return found;
}

const median = (times) => times.slice().sort((a, b) => a - b)[Math.floor(times.length / 2)];

function line(name, repeats, problems, options, budget) {
  report(name, repeats, problems, ({ problem, horizon }) => answer(problem, options(horizon), budget));
}

function report(name, repeats, cases, work) {
  const times = [];
  const statuses = {};
  for (const one of cases) {
    const runs = [];
    let status;
    for (let i = 0; i < repeats; i++) {
      const done = work(one);
      runs.push(done.milliseconds);
      status = done.status;
    }
    times.push(median(runs));
    statuses[status] = (statuses[status] ?? 0) + 1;
  }
  const said = Object.entries(statuses).map(([status, count]) => `${count} ${status}`);
  console.log(
    `${name.padEnd(34)} ${median(times).toFixed(3).padStart(11)} ms ${Math.max(...times)
      .toFixed(3)
      .padStart(11)} ms   ${said.join(", ")}`,
  );
}

console.log(`${"work".padEnd(34)} ${"median".padStart(14)} ${"worst".padStart(14)}`);
const eight = atHorizon(30, [12, 14]);
line("exact, 8x8, T = 12 or 14", 21, eight, (horizon) => ({ solver: "exact", horizon }));
line("exact, 8x8, all horizons", 21, eight, () => ({ solver: "exact", horizon: "any" }));
line("belief-flow, 8x8, T = 12 or 14", 3, eight, (horizon) => ({ solver: "ip", horizon }));
line("search, 8x8, k = 2, j = 2", 5, eight, () => ({ solver: "search", k: 2, j: 2 }));

// What the page's editor makes at its largest, as in benches/solvers.rs.
const largest = [];
for (const belief of [1, 11]) {
  for (const walls of [0, 50, 100, 150, 200]) {
    for (let seed = 0; seed < 10; seed++) {
      const size = ["--width", "32", "--height", "32", "--walls", String(walls), "--belief", String(belief)];
      const text = generate(seed, ...size);
      const problem = new Problem(text);
      const advice = problem.remedy({ solver: "exact", horizon: 0 });
      while (!advice.advance(1000)) {}
      largest.push({ text, problem, horizon: advice.outcome().shortest + 2 });
    }
  }
}
// A drag waits for no longer than this, and shows the best plan found then.
const budget = 3000;
line("exact, 32x32, all horizons", 3, largest, () => ({ solver: "exact" }), budget);
line("exact, 32x32, T = shortest + 2", 3, largest, (horizon) => ({ solver: "exact", horizon }), budget);

// Everything between a change of the document and the picture: reading it, the scene, the answer and its trace.
function whole(text) {
  const begin = performance.now();
  const problem = new Problem(text);
  problem.scene();
  const { outcome } = answer(problem, { solver: "exact" }, budget);
  if (outcome.plan) problem.trace(outcome.plan);
  const milliseconds = performance.now() - begin;
  problem.free();
  return { status: outcome.status, milliseconds };
}

function drag(name, repeats, texts) {
  report(name, repeats, texts, whole);
}
drag(
  "a drag at 8x8",
  21,
  eight.map(({ text }) => text),
);
drag(
  "a drag at 32x32",
  3,
  largest.map(({ text }) => text),
);
const four = atHorizon(10, [6, 7], "--width", "4", "--height", "4", "--belief", "4");
line("paper, 4x4, T = 6 or 7", 1, four, (horizon) => ({ solver: "ip", encoding: "paper", horizon }));
