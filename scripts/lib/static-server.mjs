// A static file server for the built page: `npm start` and the page's tests use the same one. The npm package `send`
// answers for a single file (types, ranges, revalidation, broken-off downloads); here are the port, the sub-path under
// which a course site would serve the folder, and the border of the folder.
import { realpath, stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, relative, resolve, sep } from "node:path";

/** Types that the tables of `send` do not have. */
const types = { ".jsonl": "application/jsonl; charset=utf-8" };

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
  const file = path.startsWith(base) ? await fileInside(folder, path.slice(base.length)) : null;
  if (file === null) return plain(response, 404, "not found");

  // The path is asked for as it would stand in an address.
  const address = file.split(sep).map(encodeURIComponent).join("/");
  // Loaded here: npm packages may not be there before set-up has run.
  const { default: send } = await import("send");
  send(request, address, { root: await realpath(folder), index: false, cacheControl: false })
    .on("headers", (headed, name) => {
      headed.setHeader("Cache-Control", "no-cache");
      headed.setHeader("X-Content-Type-Options", "nosniff");
      const type = types[extname(name)];
      if (type !== undefined) headed.setHeader("Content-Type", type);
    })
    .on("error", ({ status, headers }) => {
      for (const [name, value] of Object.entries(headers ?? {})) response.setHeader(name, value);
      if (status === 416) plain(response, 416, "no such range");
      else plain(response, 404, "not found");
    })
    .pipe(response);
}

/** The file that a path means, from the folder on; null where it is none, or a link leads out of the folder. */
async function fileInside(folder, wanted) {
  const named = resolve(folder, wanted === "" || wanted.endsWith("/") ? join(wanted, "index.html") : wanted);
  if (!named.startsWith(folder + sep)) return null;
  try {
    const file = relative(await realpath(folder), await realpath(named));
    const found = await stat(named);
    return found.isFile() && file !== ".." && !file.startsWith(`..${sep}`) ? file : null;
  } catch {
    return null;
  }
}

function decodedPath(address) {
  try {
    return decodeURIComponent(new URL(address, "http://localhost").pathname);
  } catch {
    return null;
  }
}

function plain(response, status, text) {
  if (response.headersSent) return response.destroy();
  response.writeHead(status, { "Content-Type": "text/plain; charset=utf-8" });
  response.end(text);
}

function redirect(response, location) {
  response.writeHead(301, { Location: location });
  response.end();
}
