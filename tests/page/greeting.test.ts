// The first word of a worker that the page has placed itself: whose script it is.
import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";
import { Greeting } from "../../www/src/worker/greeting.js";
import { VERSION } from "../../www/src/worker/names.js";
import { choosePlaces } from "../../www/src/worker/places.js";

Object.assign(globalThis, { document: { baseURI: "https://example.org/lesson/" } });
let come: () => void = () => undefined;
const asked: string[] = [];
Object.assign(globalThis, {
  fetch: (address: URL) => {
    asked.push(address.href);
    return new Promise((resolve) => {
      come = () => resolve(new Response("console.log(1)"));
    });
  },
});

let said: string[] = [];
const begin = () => new Greeting((message) => said.push(message));

beforeEach(() => {
  said = [];
  asked.length = 0;
});

test("where the page places no worker, nothing is asked of it", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const greeting = begin();
  assert.equal(greeting.takes({ kind: "hello", version: "0" }), false, "the greeting is for nobody else");
  assert.equal(greeting.takes({ kind: "ready" }), true, "what comes later is the page's");
  mock.timers.tick(60_000);
  assert.deepEqual([said, asked], [[], []]);
  mock.timers.reset();
  choosePlaces({ worker: "copy.js", wasm: null });
});

test("a worker that greets is taken, and its other messages with it", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const greeting = begin();
  greeting.takes({ kind: "hello", version: VERSION });
  assert.equal(greeting.takes({ kind: "ready" }), true, "what comes later is the page's");
  mock.timers.tick(60_000);
  assert.deepEqual([said, asked], [[], []]);
  mock.timers.reset();
});

test("another version, and a script that says something else first", () => {
  begin().takes({ kind: "hello", version: "0.0.9" });
  for (const message of [{ kind: "ready" }, "Good morning", null, undefined, 7]) begin().takes(message);
  assert.match(
    said[0] ?? "",
    new RegExp(`worker-url names, “copy.js”, .*found version “0.0.9”, expected “${VERSION}”`),
  );
  assert.equal(said.length, 6);
  for (const sentence of said.slice(1)) assert.match(sentence, /its first message is none of the worker’s/);
});

test("silence is an answer only once the script is known to be there", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  begin();
  mock.timers.tick(2999);
  assert.deepEqual(asked, []);
  mock.timers.tick(1);
  assert.deepEqual(asked, ["https://example.org/lesson/copy.js"]);
  mock.timers.tick(600_000);
  assert.deepEqual(said, []);
  come();
  await new Promise(setImmediate);
  mock.timers.tick(5000);
  assert.equal(said.length, 1);
  assert.match(said[0] ?? "", /is not its script: it runs, and gives no sign\. It is the file solver\.worker-….js/);
  mock.timers.reset();
});

test("a word that comes while the script is asked for is taken", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const greeting = begin();
  mock.timers.tick(3000);
  greeting.takes({ kind: "hello", version: VERSION });
  come();
  await new Promise(setImmediate);
  mock.timers.tick(600_000);
  assert.deepEqual(said, []);
  mock.timers.reset();
});
