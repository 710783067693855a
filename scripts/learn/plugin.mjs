// Puts the article's figures in their place, and their pictures and problems beside it.
import { readFileSync } from "node:fs";
import { inRoot } from "../lib/paths.mjs";
import { documentOf, figureNames } from "./figures.mjs";

const PAGE = "/learn/index.html";

const source = () => readFileSync(inRoot("www", "learn", "index.html"), "utf8");

/** The pictures that the article shows. Loaded when they are needed: the core must have been built by then. */
const pictures = async () => (await import("./page.mjs")).article(source()).files;

/** A plugin of Vite. */
export const learn = () => ({
  name: "learn",
  transformIndexHtml: {
    // After Vite has looked for what the page refers to: the pictures are made here.
    order: "post",
    handler: async (html, { path }) => (path === PAGE ? (await import("./page.mjs")).article(html).html : html),
  },
  async generateBundle() {
    const files = await pictures();
    for (const name of figureNames()) files.set(`${name}.json`, documentOf(name));
    for (const [file, source] of files) this.emitFile({ type: "asset", fileName: `learn/figures/${file}`, source });
  },
  configureServer(server) {
    server.middlewares.use(async (request, response, next) => {
      const file = /\/learn\/figures\/([\w.-]+\.svg)$/.exec(request.url ?? "")?.[1];
      if (file === undefined) return next();
      response.setHeader("Content-Type", "image/svg+xml");
      response.end((await pictures()).get(file));
    });
  },
});
