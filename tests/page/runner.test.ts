// The runner of `npm test`: lanes side by side, what a step needs, and the sum of it all.
import assert from "node:assert/strict";
import { mock, test } from "node:test";
import { runSteps } from "../../scripts/test/runner.mjs";

/** Runs the steps with nothing shown; resolves to the exit code and what would have been shown. */
async function quietly(steps: unknown[]): Promise<{ code: number; text: string }> {
  const lines: string[] = [];
  const take = (line: unknown) => void lines.push(String(line));
  const mocks = [mock.method(console, "log", take), mock.method(console, "error", take)];
  try {
    const code = await runSteps(steps);
    return { code, text: lines.join("\n") };
  } finally {
    for (const one of mocks) one.mock.restore();
  }
}

test("a step waits for what it needs in another lane, and those of a lane for each other", async () => {
  const order: string[] = [];
  const step = (name: string, lane: string, ms: number, needs: string[] = []) => ({
    name,
    lane,
    needs,
    run: async () => {
      await new Promise((done) => setTimeout(done, ms));
      order.push(name);
      return 0;
    },
  });
  const steps = [step("a", "one", 60), step("b", "two", 1, ["a"]), step("c", "two", 1), step("d", "one", 100)];
  const { code, text } = await quietly(steps);
  assert.equal(code, 0);
  assert.equal(order.indexOf("a"), 0);
  assert(order.indexOf("b") < order.indexOf("c"));
  assert.match(text, /4 passed, 0 failed$/);
});

test("a step that fails fails the whole; what needs it is not run, and everything else is", async () => {
  const run: string[] = [];
  const step = (name: string, lane: string, code: number, needs: string[] = []) => ({
    name,
    lane,
    needs,
    run: async () => {
      run.push(name);
      return code;
    },
  });
  const { code, text } = await quietly([
    step("build", "one", 1),
    step("use", "two", 0, ["build"]),
    step("after", "two", 0, ["use"]),
    step("other", "one", 0),
    // A need that was not asked for in this run does not count.
    step("alone", "one", 0, ["elsewhere"]),
  ]);
  assert.equal(code, 1);
  assert.deepEqual(run.sort(), ["alone", "build", "other"]);
  assert.match(text, /FAILED .*build/);
  assert.match(text, /not run .*use/);
  assert.match(text, /not run .*after/);
  assert.match(text, /2 passed, 3 failed$/);
});
