import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { documentation } from "./scripts/documentation/plugin.mjs";
import { exercises } from "./scripts/exercises/plugin.mjs";
import { learn } from "./scripts/learn/plugin.mjs";
import { openingAnswer } from "./scripts/page/opening-answer.mjs";
import { ownNames } from "./scripts/page/own-names.mjs";
import { partialDocuments } from "./scripts/page/partial-documents.mjs";
import { stylesInElement } from "./scripts/page/styles.mjs";
import { withoutAddress } from "./scripts/page/without-address.mjs";
import { thirdParty } from "./scripts/third-party/plugin.mjs";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Vite's own server adds styles by script, which the page's policy forbids; the built page keeps the policy. */
function policyInBuildOnly(): Plugin {
  return {
    name: "policy-in-build-only",
    apply: "serve",
    transformIndexHtml: (html) => html.replace(/<meta[^>]*Content-Security-Policy[^>]*>/s, ""),
  };
}

/** Other pages load the element by this name. */
const EMBED = "mo-copp-playground";

/** The licences of what others wrote and the page is made of. */
const licences = thirdParty();

export default defineConfig({
  root: here("www"),
  // Relative addresses: the page works under any sub-path.
  base: "./",
  plugins: [
    policyInBuildOnly(),
    partialDocuments(),
    stylesInElement(),
    ownNames(),
    openingAnswer(),
    documentation(),
    exercises(),
    learn(),
    licences.page,
  ],
  // One script that is a module worker on its own host and a classic one elsewhere.
  worker: { format: "iife", plugins: () => [withoutAddress(), licences.worker] },
  build: {
    outDir: here("dist"),
    emptyOutDir: true,
    target: "es2022",
    // Older than those that nest styles by themselves: then every rule is written out.
    cssTarget: ["chrome105", "firefox110", "safari16"],
    // The polyfill is for browsers older than those that run module workers.
    modulePreload: { polyfill: false },
    rollupOptions: {
      // The element's class and helpers are for other modules, too.
      preserveEntrySignatures: "allow-extension",
      // Licences, documents and the article's pictures are made by plugins.
      checks: { pluginTimings: false },
      input: {
        index: here("www/index.html"),
        embed: here("www/embed.html"),
        learn: here("www/learn/index.html"),
        [EMBED]: here("www/src/embed.ts"),
      },
      output: {
        entryFileNames: ({ name }) => (name === EMBED ? "[name].js" : "assets/[name]-[hash].js"),
      },
    },
  },
});
