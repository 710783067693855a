// Runs steps one after another and sums them up.

/** Resolves to the exit code. A step whose need failed counts as failed: what was not checked is not right. */
export async function runSteps(steps) {
  const results = [];
  for (const step of steps) {
    console.log(`\n=== ${step.name} ===`);
    const lacking = step.needs?.find((name) => results.some((result) => result.name === name && !result.passed));
    const started = performance.now();
    const passed = lacking === undefined && (await step.run()) === 0;
    const seconds = (performance.now() - started) / 1000;
    results.push({ name: step.name, passed, seconds, lacking });
    if (!passed) console.error(`=== ${step.name}: FAILED${lacking ? ` (not run: ${lacking} failed)` : ""} ===`);
  }
  summarise(results);
  return results.every((result) => result.passed) ? 0 : 1;
}

function summarise(results) {
  console.log("\n=== Summary ===");
  for (const { name, passed, seconds, lacking } of results) {
    const outcome = passed ? "passed" : lacking ? "not run" : "FAILED";
    console.log(`  ${outcome.padEnd(8)} ${`${seconds.toFixed(1)} s`.padStart(8)}  ${name}`);
  }
  const total = results.reduce((sum, result) => sum + result.seconds, 0);
  const passed = results.filter((result) => result.passed).length;
  console.log(`  in all   ${`${total.toFixed(1)} s`.padStart(8)}\n`);
  console.log(`${passed} passed, ${results.length - passed} failed`);
}
