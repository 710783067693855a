// The workers of a page: never more than three, the urgent first, however many playgrounds stand on it.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import type { Outcome, Scene, Trace } from "../../www/src/core.js";
import { runWithin } from "../../www/src/worker/patience.js";
import { type News, WorkerPool } from "../../www/src/worker/pool.js";
import { TaskRunner } from "../../www/src/worker/runner.js";
import { visit } from "./support/browser.js";
import { ScriptedWorker } from "./support/scripted-worker.js";
import { withKnownWorkers } from "./support/workers.js";

const solve = { kind: "solve", document: "{}", options: { solver: "exact" } } as const;
const solved = {
  kind: "solved",
  outcome: { status: "optimal", plan: [] } as unknown as Outcome,
  trace: { steps: [] } as unknown as Trace,
  scene: { format: "explicit" } as unknown as Scene,
} as const;

/** Ends the task that a worker was given last. */
function finish(worker: ScriptedWorker | undefined): void {
  const tasks = worker?.heard.filter((message) => message.kind !== "cancel" && message.kind !== "ahead");
  const task = tasks?.at(-1) ?? assert.fail("the worker has no task");
  worker?.say({ ...solved, id: task.id });
}
const settled = () => new Promise((resolve) => setImmediate(resolve));
const running = () => ScriptedWorker.all.filter(({ ended }) => !ended);

beforeEach(() => {
  ScriptedWorker.all = [];
});

test("no worker is started before there is a task, and none is kept when there will be none", async () => {
  const pool = new WorkerPool();
  const [one, other] = [new TaskRunner("now", pool), new TaskRunner("later", pool)];
  assert.equal(ScriptedWorker.all.length, 0);
  void one.run(solve);
  const ending = other.run(solve);
  assert.equal(running().length, 2);
  one.dispose();
  assert.equal(running().length, 2);
  other.dispose();
  assert.deepEqual(await ending, { kind: "stale" });
  assert.equal(running().length, 0);
});

test("a part that sleeps holds its task without a worker, and begins it again when it wakes", async () => {
  const pool = new WorkerPool();
  const runner = new TaskRunner("now", pool);
  const news: string[] = [];
  const first = runner.run(solve, ({ kind }) => news.push(kind));
  runner.sleep();
  // It moved within one turn.
  runner.wake();
  runner.sleep();
  assert.equal(running().length, 0);
  assert.deepEqual(news, ["waiting", "waiting"]);
  // A newer one takes its place there, too.
  const second = runner.run(solve);
  assert.deepEqual(await first, { kind: "stale" });
  assert.equal(running().length, 0);
  runner.wake();
  assert.equal(running().length, 1);
  finish(ScriptedWorker.last);
  assert.equal((await second).kind, "solved");
  const third = runner.run(solve);
  runner.sleep();
  runner.drop();
  assert.deepEqual(await third, { kind: "stale" });
});

test("a part that sleeps leaves the workers to the others, and comes back to the one it had", async () => {
  const pool = new WorkerPool();
  const [one, other] = [new TaskRunner("now", pool), new TaskRunner("now", pool)];
  const endings = [one.run(solve), other.run(solve)];
  const [worker] = ScriptedWorker.all;
  one.sleep();
  one.wake();
  await settled();
  assert.deepEqual(
    worker?.heard.map(({ kind }) => kind),
    ["solve", "cancel", "solve"],
  );
  for (const each of ScriptedWorker.all) finish(each);
  assert.deepEqual(
    (await Promise.all(endings)).map(({ kind }) => kind),
    ["solved", "solved"],
  );
});

test("tasks one after another share a worker", async () => {
  const pool = new WorkerPool();
  for (const runner of [new TaskRunner("now", pool), new TaskRunner("now", pool)]) {
    const ending = runner.run(solve);
    finish(ScriptedWorker.last);
    assert.equal((await ending).kind, "solved");
  }
  assert.equal(ScriptedWorker.all.length, 1);
});

test("what takes long leaves a worker for what is asked now", async () => {
  const pool = new WorkerPool();
  const long = Array.from({ length: 3 }, () => new TaskRunner("later", pool));
  const news: News[] = [];
  for (const runner of long) void runner.run(solve, (update) => news.push(update));
  assert.equal(ScriptedWorker.all.length, 2);
  assert.deepEqual(news, [{ kind: "waiting" }]);
  void new TaskRunner("now", pool).run(solve);
  assert.equal(ScriptedWorker.all.length, 3);
  // The one that waits follows on the first that is free.
  finish(ScriptedWorker.all[1]);
  await settled();
  assert.equal(ScriptedWorker.all[1]?.heard.length, 2);
});

test("a task finds no worker: it takes that of the least urgent one, which begins again", async () => {
  const pool = new WorkerPool();
  const told: string[] = [];
  const endings = (["later", "soon"] as const).map((urgency) =>
    new TaskRunner(urgency, pool).run(solve, ({ kind }) => told.push(`${urgency}: ${kind}`)),
  );
  void new TaskRunner("now", pool).run(solve);
  const question = new TaskRunner("now", pool).run({ kind: "trace", document: "{}", plan: [] });
  assert.equal(ScriptedWorker.all.length, 3);
  const [later] = ScriptedWorker.all;
  assert.deepEqual(
    later?.heard.map(({ kind }) => kind),
    ["solve", "trace"],
  );
  assert.deepEqual(told, ["later: waiting"]);
  later?.say({ kind: "traced", id: 2, trace: solved.trace });
  assert.equal((await question).kind, "traced");
  await settled();
  assert.deepEqual(
    later?.heard.map(({ kind }) => kind),
    ["solve", "trace", "solve"],
  );
  for (const worker of ScriptedWorker.all) finish(worker);
  assert.deepEqual(
    (await Promise.all(endings)).map(({ kind }) => kind),
    ["solved", "solved"],
  );
});

test("more tasks at once than workers wait for each other", async () => {
  const pool = new WorkerPool();
  const endings = Array.from({ length: 5 }, () => new TaskRunner("now", pool).run(solve));
  assert.equal(ScriptedWorker.all.length, 3);
  for (let round = 0; round < 2; round += 1) {
    for (const worker of ScriptedWorker.all) finish(worker);
    await settled();
  }
  assert.deepEqual(
    (await Promise.all(endings)).map(({ kind }) => kind),
    Array.from({ length: 5 }, () => "solved"),
  );
  assert.equal(ScriptedWorker.all.length, 3);
});

test("a newer task of the same part takes the worker of the older", async () => {
  const runner = new TaskRunner("now", new WorkerPool());
  const first = runner.run(solve);
  const second = runner.run(solve);
  assert.deepEqual(await first, { kind: "stale" });
  finish(ScriptedWorker.last);
  assert.equal((await second).kind, "solved");
  assert.equal(ScriptedWorker.all.length, 1);
});

test("a task that waits can be cancelled and dropped", async () => {
  const pool = new WorkerPool();
  for (let count = 0; count < 3; count += 1) void new TaskRunner("now", pool).run(solve);
  const [cancelled, dropped] = [new TaskRunner("now", pool), new TaskRunner("now", pool)];
  const endings = [cancelled.run(solve), dropped.run(solve)];
  cancelled.cancel();
  dropped.drop();
  assert.deepEqual(
    (await Promise.all(endings)).map(({ kind }) => kind),
    ["refused", "stale"],
  );
  for (const worker of ScriptedWorker.all) finish(worker);
  await settled();
  for (const { heard } of ScriptedWorker.all) assert.equal(heard.length, 1);
});

test("the time that a task waits for a worker is not taken from its patience", async (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const pool = new WorkerPool();
  let over = 0;
  const patience = { milliseconds: 1000, over: () => (over += 1) };
  void runWithin(new TaskRunner("later", pool), solve, patience);
  const [worker] = ScriptedWorker.all;
  worker?.say({ kind: "ready" });
  worker?.say({ kind: "started", id: 1 });
  context.mock.timers.tick(900);
  for (let count = 0; count < 3; count += 1) void new TaskRunner("now", pool).run(solve);
  context.mock.timers.tick(1500);
  assert.equal(over, 0);
});

test("six playgrounds on a page share three workers", () =>
  visit(
    async ({ page }) => {
      await page.evaluate(() => {
        for (let count = 0; count < 5; count += 1) {
          const element = document.createElement("mo-copp-playground");
          element.setAttribute("link", "off");
          document.body.append(element);
        }
      });
      await page.waitForFunction(
        () => document.querySelectorAll('mo-copp-playground[data-status="optimal"]').length === 6,
      );
      const started = await page.evaluate("workers.length");
      assert(Number(started) <= 3, `${started} workers`);
    },
    { before: withKnownWorkers },
  ));
