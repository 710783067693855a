// The page's side of the worker, with workers that do just what a test tells them.
import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";
import type { Outcome, Progress, Scene, Trace } from "../../www/src/core.js";
import { type Ending, SolverClient } from "../../www/src/worker/client.js";
import { runWithin } from "../../www/src/worker/patience.js";
import { ScriptedWorker } from "./support/scripted-worker.js";

const solve = { kind: "solve", document: "{}", options: { solver: "exact" } } as const;
const goals = { adversarial: ["G1", "G2"], cooperative: ["G1"] };
const trace = { valid: true, steps: [{ goals, goal_difference: 1 }], goal_difference: 1 } as unknown as Trace;
const scene = { format: "explicit" } as unknown as Scene;
const outcome = { status: "optimal", plan: [] } as unknown as Outcome;
const progress = (plan: string[] | null) => ({ solver: "exact", plan }) as unknown as Progress;

beforeEach(() => {
  ScriptedWorker.all = [];
});

test("a reply to an older request is dropped", async () => {
  const client = new SolverClient();
  const first = client.run(solve);
  const second = client.run(solve);
  assert.deepEqual(await first, { kind: "stale" });
  ScriptedWorker.last.say({ kind: "solved", id: 1, outcome, trace, scene });
  ScriptedWorker.last.say({ kind: "solved", id: 2, outcome, trace, scene });
  assert.deepEqual(await second, { kind: "solved", id: 2, outcome, trace, scene });
  assert.equal(ScriptedWorker.all.length, 1);
});

test("progress is reported, of the current request alone", async () => {
  const client = new SolverClient();
  const seen: (string[] | null)[] = [];
  void client.run(solve, (update) => update.kind === "progress" && seen.push(update.progress.plan));
  ScriptedWorker.last.say({ kind: "progress", id: 7, progress: progress(["west"]) });
  ScriptedWorker.last.say({ kind: "progress", id: 1, progress: progress(["east"]) });
  assert.deepEqual(seen, [["east"]]);
});

test("a cancel that is answered keeps the worker and its answer", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const client = new SolverClient();
  const ending = client.run(solve);
  client.cancel();
  client.cancel();
  assert.deepEqual(ScriptedWorker.last.heard.slice(1), [{ kind: "cancel", id: 1 }]);
  ScriptedWorker.last.say({ kind: "solved", id: 1, outcome, trace, scene });
  mock.timers.tick(60_000);
  assert.equal((await ending).kind, "solved");
  assert.equal(ScriptedWorker.last.ended, false);
  mock.timers.reset();
});

test("a cancel without an answer ends the worker; another replays the best plan reported", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const client = new SolverClient();
  const ending = client.run(solve);
  const deaf = ScriptedWorker.last;
  deaf.say({ kind: "opened", id: 1, scene, start: trace });
  deaf.say({ kind: "progress", id: 1, progress: progress(["east", "north"]) });
  client.cancel();
  mock.timers.tick(2000);
  assert(deaf.ended);
  const { heard } = ScriptedWorker.last;
  assert.deepEqual(heard, [{ kind: "trace", id: 2, document: "{}", plan: ["east", "north"] }]);
  ScriptedWorker.last.say({ kind: "traced", id: 2, trace });
  assert.deepEqual(await ending, {
    kind: "solved",
    replaced: true,
    scene,
    trace,
    outcome: {
      ...{ status: "feasible", solver: "exact", horizon: 2, plan: ["east", "north"] },
      ...{ goals, goal_difference: 1, stats: {} },
    },
  });
  mock.timers.reset();
});

test("a cancel without an answer and without a plan tells of a limit", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const client = new SolverClient();
  const ending = client.run(solve);
  ScriptedWorker.last.say({ kind: "opened", id: 1, scene, start: trace });
  client.cancel();
  mock.timers.tick(2000);
  const end = (await ending) as Extract<Ending, { kind: "solved" }>;
  assert.equal(end.outcome.status, "limit");
  assert.equal(end.trace, trace);
  mock.timers.reset();
});

test("a cancel before the problem was read ends with a message", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const client = new SolverClient();
  const ending = client.run(solve);
  client.cancel();
  mock.timers.tick(2000);
  assert.equal((await ending).kind, "refused");
  mock.timers.reset();
});

test("a task that a busy worker does not take up goes to another worker", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const client = new SolverClient();
  void client.run(solve);
  const busy = ScriptedWorker.last;
  busy.say({ kind: "ready" });
  busy.say({ kind: "started", id: 1 });
  mock.timers.tick(60_000);
  assert.equal(busy.ended, false);
  const newer = client.run(solve);
  mock.timers.tick(2000);
  assert(busy.ended);
  assert.deepEqual(ScriptedWorker.last.heard, [{ ...solve, id: 2 }]);
  ScriptedWorker.last.say({ kind: "solved", id: 2, outcome, trace, scene });
  assert.equal((await newer).kind, "solved");
  mock.timers.reset();
});

test("a worker that is still loading is waited for", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  void new SolverClient().run(solve);
  mock.timers.tick(60_000);
  assert.equal(ScriptedWorker.all.length, 1);
  mock.timers.reset();
});

test("patience counts from when the worker takes the task up", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const client = new SolverClient();
  let over = 0;
  const patience = { milliseconds: 5000, over: () => (over += 1) };
  const ending = runWithin(client, solve, patience);
  const { heard } = ScriptedWorker.last;
  mock.timers.tick(60_000);
  assert.deepEqual([over, heard.length], [0, 1]);
  ScriptedWorker.last.say({ kind: "ready" });
  ScriptedWorker.last.say({ kind: "started", id: 1 });
  mock.timers.tick(4999);
  assert.equal(over, 0);
  mock.timers.tick(1);
  assert.deepEqual([over, heard.at(-1)], [1, { kind: "cancel", id: 1 }]);
  ScriptedWorker.last.say({ kind: "solved", id: 1, outcome, trace, scene });
  assert.equal((await ending).kind, "solved");
  // The next task has a patience of its own, and one that has ended none.
  const next = runWithin(client, solve, patience);
  ScriptedWorker.last.say({ kind: "started", id: 2 });
  ScriptedWorker.last.say({ kind: "solved", id: 2, outcome, trace, scene });
  await next;
  mock.timers.tick(60_000);
  assert.equal(over, 1);
  const patient = runWithin(client, solve, { milliseconds: Number.POSITIVE_INFINITY });
  ScriptedWorker.last.say({ kind: "started", id: 3 });
  mock.timers.tick(1e9);
  assert.equal(ScriptedWorker.last.heard.filter(({ kind }) => kind === "cancel").length, 1);
  client.dispose();
  assert.equal((await patient).kind, "stale");
  mock.timers.reset();
});

test("a panic ends the request and puts another worker in place", async () => {
  const client = new SolverClient();
  const ending = client.run(solve);
  const broken = ScriptedWorker.last;
  broken.say({ kind: "ready" });
  broken.say({ kind: "broken", id: 1, message: "unreachable" });
  assert.deepEqual(await ending, { kind: "lost", message: "unreachable" });
  assert(broken.ended);
  assert.equal(ScriptedWorker.all.length, 2);
  const next = client.run(solve);
  ScriptedWorker.last.say({ kind: "solved", id: 2, outcome, trace, scene });
  assert.equal((await next).kind, "solved");
});

test("a worker that never came up is not replaced over and over", async () => {
  const client = new SolverClient();
  const ending = client.run(solve);
  ScriptedWorker.last.onerror?.({ message: "", preventDefault: () => undefined });
  assert.deepEqual(await ending, { kind: "lost", message: "its script did not come", unstarted: true });
  assert.equal(ScriptedWorker.all.length, 1);
  void client.run(solve);
  assert.equal(ScriptedWorker.all.length, 2);
});

test("patience counts the time at work, not the time that fetching the full core takes", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const client = new SolverClient();
  let over = 0;
  const patience = { milliseconds: 1000, over: () => (over += 1) };
  void runWithin(client, solve, patience);
  ScriptedWorker.last.say({ kind: "started", id: 1 });
  mock.timers.tick(900);
  ScriptedWorker.last.say({ kind: "fetching", id: 1 });
  mock.timers.tick(60_000);
  assert.equal(over, 0);
  ScriptedWorker.last.say({ kind: "started", id: 1 });
  mock.timers.tick(999);
  assert.equal(over, 0);
  mock.timers.tick(1);
  assert.equal(over, 1);
  client.dispose();
  mock.timers.reset();
});

test("the full core is fetched in a pause after an answer, not while there is work, nor where data is to be saved", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const told = () => ScriptedWorker.last.heard.filter(({ kind }) => kind === "ahead").length;
  const client = new SolverClient();
  client.lookAhead();
  const answer = async () => {
    const ending = client.run(solve);
    const { id } = ScriptedWorker.last.heard.at(-1) as { id: number };
    ScriptedWorker.last.say({ kind: "solved", id, outcome, trace, scene });
    await ending;
  };
  await answer();
  mock.timers.tick(900);
  await answer();
  mock.timers.tick(900);
  assert.equal(told(), 0);
  mock.timers.tick(100);
  assert.equal(told(), 1);
  const connection = { saveData: true };
  const before = Object.getOwnPropertyDescriptor(globalThis, "navigator");
  Object.defineProperty(globalThis, "navigator", { value: { connection }, configurable: true });
  await answer();
  mock.timers.tick(5000);
  assert.equal(told(), 1);
  if (before) Object.defineProperty(globalThis, "navigator", before);
  else Reflect.deleteProperty(globalThis, "navigator");
  client.dispose();
  mock.timers.reset();
});

test("the full core is not fetched ahead before somebody is at work, and then in the next pause", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const told = () => ScriptedWorker.last.heard.filter(({ kind }) => kind === "ahead").length;
  const client = new SolverClient();
  const ending = client.run(solve);
  ScriptedWorker.last.say({ kind: "ready" });
  ScriptedWorker.last.say({ kind: "solved", id: 1, outcome, trace, scene });
  await ending;
  mock.timers.tick(60_000);
  assert.equal(told(), 0);
  client.lookAhead();
  assert.equal(told(), 0);
  mock.timers.tick(1000);
  assert.equal(told(), 1);
  // Said again, it changes nothing.
  client.lookAhead();
  mock.timers.tick(60_000);
  assert.equal(told(), 1);
  client.dispose();
  mock.timers.reset();
});
