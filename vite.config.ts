import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { documentation } from "./scripts/documentation/plugin.mjs";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Vite's own server adds styles by script, which the page's policy forbids; the built page keeps the policy. */
function policyInBuildOnly(): Plugin {
  return {
    name: "policy-in-build-only",
    apply: "serve",
    transformIndexHtml: (html) => html.replace(/<meta[^>]*Content-Security-Policy[^>]*>/s, ""),
  };
}

/** Styles of the page around the element, and those that name the element themselves. */
const ofThePage = /\/style\/(site|embed-page|colours)\.css$/;

/** The element stands in other people's pages: its styles are for what is in it, and weigh as much as before. */
function stylesInElement(): Plugin {
  return {
    name: "styles-in-element",
    enforce: "pre",
    transform(code, id) {
      if (!/\/www\/src\/style\/[^/]+\.css$/.test(id) || ofThePage.test(id)) return null;
      return { code: `:where(mo-copp-playground, .mo-copp-part) {\n${code}\n}\n`, map: null };
    },
  };
}

/** Other pages load the element by this name. */
const EMBED = "mo-copp-playground";

export default defineConfig({
  root: here("www"),
  // Relative addresses: the page works under any sub-path.
  base: "./",
  plugins: [policyInBuildOnly(), stylesInElement(), documentation()],
  worker: { format: "es" },
  build: {
    outDir: here("dist"),
    emptyOutDir: true,
    target: "es2022",
    // Older than those that nest styles by themselves: then every rule is written out.
    cssTarget: ["chrome105", "firefox110", "safari16"],
    // The polyfill is for browsers older than those that run module workers.
    modulePreload: { polyfill: false },
    rollupOptions: {
      input: { index: here("www/index.html"), embed: here("www/embed.html"), [EMBED]: here("www/src/embed.ts") },
      output: {
        entryFileNames: ({ name }) => (name === EMBED ? "[name].js" : "assets/[name]-[hash].js"),
      },
    },
  },
});
