// A host for pages that a test writes, with the built page beside them. (A browser counts what a test answers in the
// network's place for a page of the internet, which may not read files of this machine.)
import { readFile } from "node:fs/promises";
import { createServer, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join } from "node:path";
import { after } from "node:test";
import { dist } from "../../../scripts/lib/paths.mjs";

const types: Record<string, string> = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".json": "application/json",
  ".wasm": "application/wasm",
};

export interface Answer {
  /** Or what sends it, part by part. */
  body: string | Uint8Array | ((response: ServerResponse) => void);
  headers?: Record<string, string>;
}

export interface Host {
  /** Ends with a slash; the built page's files are below it. */
  address: string;
  /** The pages and files of this host's own, by path. */
  own: Map<string, Answer>;
}

/** Starts a host; `headers` go with every answer. */
export async function startHost(headers: Record<string, string> = {}): Promise<Host> {
  const own = new Map<string, Answer>();
  const server = createServer(async ({ url = "" }, response) => {
    const path = decodeURIComponent(new URL(url, "http://localhost").pathname).slice(1);
    const answer = own.get(path) ?? (await fromDist(path));
    const type = types[extname(path)] ?? "application/octet-stream";
    response.writeHead(answer === null ? 404 : 200, { "Content-Type": type, ...headers, ...answer?.headers });
    if (typeof answer?.body === "function") answer.body(response);
    else response.end(answer?.body);
  });
  await new Promise<void>((listening) => server.listen(0, "127.0.0.1", listening));
  after(() => {
    server.close();
    server.closeAllConnections();
  });
  return { address: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`, own };
}

const fromDist = (path: string): Promise<Answer | null> =>
  readFile(join(dist, path)).then(
    (body) => ({ body }),
    () => null,
  );
