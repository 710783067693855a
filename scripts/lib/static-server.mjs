// A small static file server for the built page: `npm start` and the page's tests use the same one.
// It can serve the folder under a sub-path, as a course site would.
import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, resolve, sep } from "node:path";

const types = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".map": "application/json; charset=utf-8",
  ".svg": "image/svg+xml",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
};

/**
 * Serves `folder` under `base` (which begins and ends with a slash).
 * With `anyPort`, the next free port is taken when `port` is in use. Resolves to the server and its address.
 */
export async function serve(folder, { port = 0, host = "127.0.0.1", base = "/", anyPort = false } = {}) {
  const server = createServer((request, response) => {
    answer(resolve(folder), base, request, response).catch(() => plain(response, 500, "internal error"));
  });
  const taken = await listen(server, port, host, anyPort);
  return { server, address: `http://${host.includes(":") ? `[${host}]` : host}:${taken}${base}` };
}

async function listen(server, port, host, anyPort) {
  for (let candidate = port; ; candidate += 1) {
    try {
      await new Promise((done, fail) => {
        server.once("error", fail);
        server.listen(candidate, host, () => {
          server.off("error", fail);
          done();
        });
      });
      return server.address().port;
    } catch (error) {
      if (error.code !== "EADDRINUSE" || !anyPort || candidate >= port + 50) throw error;
    }
  }
}

async function answer(folder, base, request, response) {
  if (request.method !== "GET" && request.method !== "HEAD") return plain(response, 405, "only GET and HEAD");
  const path = decodedPath(request.url);
  if (path === null) return plain(response, 400, "bad address");
  if (`${path}/` === base) return redirect(response, base);
  if (!path.startsWith(base)) return plain(response, 404, "not found");

  const wanted = path.slice(base.length);
  const file = resolve(folder, wanted === "" || wanted.endsWith("/") ? join(wanted, "index.html") : wanted);
  if (!file.startsWith(folder + sep)) return plain(response, 404, "not found");
  const found = await stat(file).catch(() => null);
  if (!found?.isFile()) return plain(response, 404, "not found");

  response.writeHead(200, {
    "Content-Type": types[extname(file)] ?? "application/octet-stream",
    "Content-Length": found.size,
    "Cache-Control": "no-cache",
    "X-Content-Type-Options": "nosniff",
  });
  if (request.method === "HEAD") response.end();
  else createReadStream(file).pipe(response);
}

function decodedPath(address) {
  try {
    return decodeURIComponent(new URL(address, "http://localhost").pathname);
  } catch {
    return null;
  }
}

function plain(response, status, text) {
  if (!response.headersSent) response.writeHead(status, { "Content-Type": "text/plain; charset=utf-8" });
  response.end(text);
}

function redirect(response, location) {
  response.writeHead(301, { Location: location });
  response.end();
}
