// The static server that `npm start` and these tests use.
import assert from "node:assert/strict";
import fs, { chmodSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, truncateSync, writeFileSync } from "node:fs";
import { type IncomingMessage, request } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { serve } from "../../scripts/lib/static-server.mjs";

const outer = mkdtempSync(join(tmpdir(), "mo-copp-"));
writeFileSync(join(outer, "secret.txt"), "not yours");
const folder = mkdtempSync(join(outer, "site-"));
const put = (name: string, text: string) => writeFileSync(join(folder, name), text);
put("index.html", "<p>page</p>");
put("core.wasm", "\0asm");
const { server, address } = await serve(folder, { base: "/sub/" });
after(() => {
  server.close();
  rmSync(outer, { recursive: true });
});

interface Answer {
  status: number;
  headers: IncomingMessage["headers"];
  body: string;
}

/** Asks for a path just as written: `fetch` would tidy it up first. */
function ask(path: string, method = "GET", headers: Record<string, string> = {}): Promise<Answer> {
  return new Promise((resolve, reject) => {
    request(new URL(address), { path, method, headers, agent: false }, (response) => {
      let body = "";
      response.on("data", (part) => (body += part));
      response.on("error", reject);
      response.on("end", () => resolve({ status: response.statusCode ?? 0, headers: response.headers, body }));
    })
      .on("error", reject)
      .end();
  });
}

test("files are served under the sub-path, with their types", async () => {
  assert.match((await ask("/sub/")).headers["content-type"] ?? "", /^text\/html/);
  assert.equal((await ask("/sub/?from=mail")).body, "<p>page</p>");
  assert.equal((await ask("/sub")).headers.location, "/sub/");
  for (const [name, type] of [
    ["core.wasm", "application/wasm"],
    ["table.csv", "text/csv; charset=utf-8"],
    ["records.jsonl", "application/jsonl; charset=utf-8"],
    ["problem.json", "application/json; charset=utf-8"],
    ["page.js", "text/javascript; charset=utf-8"],
    ["page.css", "text/css; charset=utf-8"],
    ["picture.svg", "image/svg+xml"],
    ["NOTICE.txt", "text/plain; charset=utf-8"],
    ["50% of a, é.txt", "text/plain; charset=utf-8"],
  ] as const) {
    put(name, "what stands in it");
    const { status, headers, body } = await ask(`/sub/${encodeURIComponent(name)}`);
    assert.deepEqual([status, headers["content-type"], body], [200, type, "what stands in it"], name);
    assert.equal(headers["x-content-type-options"], "nosniff");
  }
  const { headers, body } = await ask("/sub/index.html", "HEAD");
  assert.deepEqual([headers["content-length"], body], ["11", ""]);
});

test("nothing else is", async () => {
  const outside = ["/", "/sub/none.js", "/sub/../secret.txt", "/sub/..%2fsecret.txt", "/sub/%2e%2e/secret.txt"];
  for (const path of [...outside, "/sub//etc/passwd", "/sub/%00", "/sub/core.wasm/"]) {
    assert.equal((await ask(path)).status, 404, path);
  }
  assert.equal((await ask("/sub/%zz")).status, 400);
  assert.equal((await ask("/sub/", "POST")).status, 405);
});

test("a link out of the folder is not followed, one inside of it is", async () => {
  symlinkSync(join(outer, "secret.txt"), join(folder, "file-out.txt"));
  symlinkSync(outer, join(folder, "folder-out"));
  symlinkSync("index.html", join(folder, "inside.html"));
  symlinkSync("nowhere", join(folder, "nowhere.html"));
  for (const path of ["file-out.txt", "folder-out/secret.txt", "nowhere.html"]) {
    assert.equal((await ask(`/sub/${path}`)).status, 404, path);
  }
  assert.equal((await ask("/sub/inside.html")).body, "<p>page</p>");
});

test("a part of a file can be asked for", async () => {
  put("digits.txt", "0123456789");
  const part = await ask("/sub/digits.txt", "GET", { range: "bytes=2-4" });
  assert.deepEqual([part.status, part.body, part.headers["content-range"]], [206, "234", "bytes 2-4/10"]);
  const none = await ask("/sub/digits.txt", "GET", { range: "bytes=20-" });
  assert.deepEqual([none.status, none.headers["content-range"]], [416, "bytes */10"]);
});

test("a file that can't be read, or is gone when it is opened, ends its own answer alone", async () => {
  put("locked.txt", "locked");
  chmodSync(join(folder, "locked.txt"), 0o000);
  chmodSync(outer, 0o755);
  chmodSync(folder, 0o755);
  // Root reads everything, so the process has another user for a moment.
  const root = process.geteuid?.() === 0;
  if (root) process.seteuid?.(65534);
  try {
    await assert.rejects(fs.promises.readFile(join(folder, "locked.txt")), { code: "EACCES" });
    const locked = await ask("/sub/locked.txt").catch(() => null);
    assert.notEqual(locked?.status, 200);
    assert.equal((await ask("/sub/")).status, 200);
  } finally {
    if (root) process.seteuid?.(0);
  }
  const original = fs.createReadStream;
  fs.createReadStream = ((path: string, options: object) => {
    rmSync(path);
    return original(path, options as never);
  }) as typeof fs.createReadStream;
  try {
    put("going.txt", "going");
    const gone = await ask("/sub/going.txt").catch(() => null);
    assert.notEqual(gone?.status, 200);
  } finally {
    fs.createReadStream = original;
  }
  assert.equal((await ask("/sub/")).status, 200);
});

test("a download that is broken off gives its file back", async () => {
  put("large.bin", "");
  truncateSync(join(folder, "large.bin"), 64 << 20);
  const original = fs.createReadStream;
  const closed: Promise<unknown>[] = [];
  fs.createReadStream = ((path: string, options: object) => {
    const stream = original(path, options as never);
    closed.push(new Promise((done) => stream.once("close", () => done(undefined))));
    return stream;
  }) as typeof fs.createReadStream;
  try {
    const begun = Array.from(
      { length: 20 },
      () =>
        new Promise<void>((done) => {
          const asked = request(new URL("large.bin", address), { agent: false }, (response) => {
            response.once("data", () => {
              asked.destroy();
              done();
            });
          });
          asked.on("error", () => undefined);
          asked.end();
        }),
    );
    await Promise.all(begun);
    assert.equal(closed.length, 20);
    await Promise.all(closed);
  } finally {
    fs.createReadStream = original;
  }
});

test("a port in use moves on to the next when any will do", async () => {
  const port = Number(new URL(address).port);
  const second = await serve(folder, { port, anyPort: true });
  assert(Number(new URL(second.address).port) > port);
  second.server.close();
  await assert.rejects(serve(folder, { port }), { code: "EADDRINUSE" });
});

test("a folder without its files is no reason to end", async () => {
  mkdirSync(join(outer, "empty"));
  const bare = await serve(join(outer, "empty"));
  assert.equal((await fetch(bare.address)).status, 404);
  rmSync(join(outer, "empty"), { recursive: true });
  assert.equal((await fetch(bare.address)).status, 404);
  bare.server.close();
  bare.server.closeAllConnections();
});
