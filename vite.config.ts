import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Vite's own server adds styles by script, which the page's policy forbids; the built page keeps the policy. */
function policyInBuildOnly(): Plugin {
  return {
    name: "policy-in-build-only",
    apply: "serve",
    transformIndexHtml: (html) => html.replace(/<meta[^>]*Content-Security-Policy[^>]*>/s, ""),
  };
}

export default defineConfig({
  root: here("www"),
  // Relative addresses: the page works under any sub-path.
  base: "./",
  plugins: [policyInBuildOnly()],
  worker: { format: "es" },
  build: {
    outDir: here("dist"),
    emptyOutDir: true,
    target: "es2022",
    // The polyfill is for browsers older than those that run module workers.
    modulePreload: { polyfill: false },
  },
});
