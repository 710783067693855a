// Runs steps and sums them up. Steps of one lane run one after another (they share a folder that one program at a time
// may write, or the browser); lanes run side by side where there is more than one core.
import { availableParallelism } from "node:os";

/** Resolves to the exit code. A step whose need failed counts as failed: what was not checked is not right. */
export async function runSteps(steps) {
  const lanes = availableParallelism() > 1 ? [...new Set(steps.map(({ lane }) => lane))] : [null];
  const begun = performance.now();
  const finished = new Map();
  for (const step of steps) finished.set(step.name, deferred());
  const inLane = (lane) => steps.filter((step) => lane === null || step.lane === lane);
  await Promise.all(
    lanes.map(async (lane) => {
      for (const step of inLane(lane)) finished.get(step.name).resolve(await runStep(step, finished, lanes.length > 1));
    }),
  );
  const results = await Promise.all(steps.map(({ name }) => finished.get(name).promise));
  summarise(results, (performance.now() - begun) / 1000);
  return results.every(({ passed }) => passed) ? 0 : 1;
}

async function runStep({ name, needs = [], run }, finished, beside) {
  const earlier = await Promise.all(needs.map((need) => finished.get(need)?.promise));
  const lacking = earlier.find((result) => result?.passed === false)?.name;
  const pieces = [];
  if (!beside) console.log(`\n=== ${name} ===`);
  const started = performance.now();
  // Beside others the output waits until it can be shown whole.
  const options = beside ? { output: (piece) => pieces.push(Buffer.from(piece)) } : {};
  const passed = lacking === undefined && (await run(options)) === 0;
  const seconds = (performance.now() - started) / 1000;
  if (beside) {
    console.log(`\n=== ${name} ===`);
    process.stdout.write(Buffer.concat(pieces));
  }
  if (!passed) console.error(`=== ${name}: FAILED${lacking ? ` (not run: ${lacking} failed)` : ""} ===`);
  else if (beside) console.log(`=== ${name}: passed, ${seconds.toFixed(1)} s ===`);
  return { name, passed, seconds, lacking };
}

function deferred() {
  let resolve;
  const promise = new Promise((done) => {
    resolve = done;
  });
  return { promise, resolve };
}

function summarise(results, total) {
  console.log("\n=== Summary ===");
  for (const { name, passed, seconds, lacking } of results) {
    const outcome = passed ? "passed" : lacking ? "not run" : "FAILED";
    console.log(`  ${outcome.padEnd(8)} ${`${seconds.toFixed(1)} s`.padStart(8)}  ${name}`);
  }
  const passed = results.filter((result) => result.passed).length;
  console.log(`  in all   ${`${total.toFixed(1)} s`.padStart(8)}\n`);
  console.log(`${passed} passed, ${results.length - passed} failed`);
}
