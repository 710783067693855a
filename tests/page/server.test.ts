// The static server that `npm start` and these tests use.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { request } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { serve } from "../../scripts/lib/static-server.mjs";

const outer = mkdtempSync(join(tmpdir(), "mo-copp-"));
writeFileSync(join(outer, "secret.txt"), "not yours");
const folder = mkdtempSync(join(outer, "site-"));
writeFileSync(join(folder, "index.html"), "<p>page</p>");
writeFileSync(join(folder, "core.wasm"), "\0asm");
const { server, address } = await serve(folder, { base: "/sub/" });
after(() => {
  server.close();
  rmSync(outer, { recursive: true });
});

/** Asks for a path just as written: `fetch` would tidy it up first. */
function ask(path: string, method = "GET"): Promise<{ status: number; type: string; location: string; body: string }> {
  return new Promise((resolve, reject) => {
    request(new URL(address), { path, method }, (response) => {
      let body = "";
      response.on("data", (part) => (body += part));
      response.on("end", () =>
        resolve({
          status: response.statusCode ?? 0,
          type: response.headers["content-type"] ?? "",
          location: response.headers.location ?? "",
          body,
        }),
      );
    })
      .on("error", reject)
      .end();
  });
}

test("files are served under the sub-path, with their types", async () => {
  assert.match((await ask("/sub/")).type, /^text\/html/);
  assert.equal((await ask("/sub/?from=mail")).body, "<p>page</p>");
  assert.equal((await ask("/sub/core.wasm")).type, "application/wasm");
  assert.equal((await ask("/sub")).location, "/sub/");
});

test("nothing else is", async () => {
  const outside = ["/", "/sub/none.js", "/sub/../secret.txt", "/sub/..%2fsecret.txt", "/sub/%2e%2e/secret.txt"];
  for (const path of [...outside, "/sub//etc/passwd", "/sub/%00", "/sub/core.wasm/"]) {
    assert.equal((await ask(path)).status, 404, path);
  }
  assert.equal((await ask("/sub/%zz")).status, 400);
  assert.equal((await ask("/sub/", "POST")).status, 405);
});

test("a port in use moves on to the next when any will do", async () => {
  const port = Number(new URL(address).port);
  const second = await serve(folder, { port, anyPort: true });
  assert(Number(new URL(second.address).port) > port);
  second.server.close();
  await assert.rejects(serve(folder, { port }), { code: "EADDRINUSE" });
});
