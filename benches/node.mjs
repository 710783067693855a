// Times the solvers in wasm under Node beside the same solvers of the command, on the problems of the first lines of
// `cargo bench` and on the paper's planning domains. The command is a new process for each answer, wasm is warm, so that
// what takes a few milliseconds says little of the compiled code; the last line has the ratios of all and of what is longer:
//   node benches/node.mjs
// Needs what `npm run setup` installs, the page's core (`npm run build`) and `cargo build --release`.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { inRoot, root } from "../scripts/lib/paths.mjs";

const command = inRoot("target", "release", "mo-copp");
const run = (program, args, input) => {
  try {
    return execFileSync(program, args, { cwd: root, encoding: "utf8", input, stdio: ["pipe", "pipe", "ignore"] });
  } catch (error) {
    // A limit is told by the exit code; the answer is there all the same.
    if (error.stdout) return error.stdout;
    throw error;
  }
};

const core = inRoot("www", "pkg", "mo_copp");
const { initSync, Problem } = await import(`${core}.js`);
initSync({ module: readFileSync(`${core}_bg.wasm`) });

const generate = (seed, ...size) => run(command, ["generate", "gridworld", "--seed", String(seed), ...size]);
const draw = (domain, seed) => {
  const text = run(command, ["generate", domain, "--seed", String(seed)]);
  return { text, problem: new Problem(text) };
};

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
  const work = ({ problem, horizon }) => answer(problem, options(horizon), budget);
  // What is cut off here would go on there.
  const beside = budget === undefined ? ({ text, horizon }) => native(text, options(horizon)) : null;
  report(name, repeats, problems, work, beside);
}

/** What the command takes for the same, by its own clock, in milliseconds. */
function native(text, options) {
  const args = Object.entries(options).flatMap(([name, value]) => [`--${name}`, String(value)]);
  const times = [1, 2, 3].map(() => JSON.parse(run(command, ["solve", "-", "--json", ...args], text)).stats.seconds);
  return median(times) * 1000;
}

const ratios = [];
/** Of the lines whose problems take the command at least this long in the mean. */
const long = [];
const LONG_MS = 10;

function report(name, repeats, cases, work, beside = null) {
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
  // All problems of the line together: one alone may take less than the clock tells.
  const sum = (all) => all.reduce((total, one) => total + one, 0);
  const besides = beside === null ? [] : cases.map(beside);
  const ratio = beside === null ? null : sum(times) / sum(besides);
  if (ratio !== null) ratios.push(ratio);
  if (ratio !== null && sum(besides) >= LONG_MS * cases.length) long.push(ratio);
  const column = (time) => `${time.toFixed(3).padStart(11)} ms`;
  console.log(
    `${name.padEnd(34)} ${column(median(times))} ${column(Math.max(...times))} ${(ratio?.toFixed(2) ?? "–").padStart(8)}   ${said.join(", ")}`,
  );
}

console.log(`${"work".padEnd(34)} ${"median".padStart(14)} ${"worst".padStart(14)} ${"× native".padStart(8)}`);
const eight = atHorizon(30, [12, 14]);
line("exact, 8x8, T = 12 or 14", 21, eight, (horizon) => ({ solver: "exact", horizon }));
line("exact, 8x8, all horizons", 21, eight, () => ({ solver: "exact", horizon: "any" }));
line("belief-flow, 8x8, T = 12 or 14", 3, eight, (horizon) => ({ solver: "ip", horizon }));
const search = { solver: "search", k: 2, j: 2 };
line("search, 8x8, k = 2, j = 2", 5, eight, () => search);

const ten = (domain) => Array.from({ length: 10 }, (_, seed) => draw(domain, seed + 1));
const domains = ["box-pushing", "driverlog", "logistics"].map((domain) => [domain, ten(domain)]);
for (const [domain, problems] of domains) line(`exact, ${domain}`, 1, problems, () => ({ solver: "exact" }));
for (const [domain, problems] of domains) {
  // Elsewhere the search goes on to the limit on memory, which differs.
  const solved = problems.filter(({ problem }) => answer(problem, search).status === "solved");
  line(`search, ${domain}, k = 2, j = 2`, 1, solved, () => search);
}

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

for (const [which, all] of [
  ["all lines", ratios],
  [`lines of ${LONG_MS} ms and more`, long],
]) {
  console.log(`wasm to native, ${which}: median ${median(all).toFixed(2)}, worst ${Math.max(...all).toFixed(2)}`);
}
