// The element as one file, dist/mo-copp-playground.single.js: a classic script with the worker and the whole core inside.
import { readFileSync } from "node:fs";
import { compress } from "lzma1";
import { build } from "vite";
import { dist, inRoot } from "../lib/paths.mjs";
import { onlyAscii } from "./ascii.mjs";
import { withoutOpeningAnswer } from "./opening-answer.mjs";
import { ownNames } from "./own-names.mjs";
import { stylesInElement } from "./styles.mjs";
import { withoutAddress } from "./without-address.mjs";

/** Resolves to the exit code. */
export async function buildSingle() {
  try {
    await build({
      configFile: false,
      logLevel: "warn",
      root: inRoot("www"),
      publicDir: false,
      plugins: [ownNames(), stylesInElement(), withoutOpeningAnswer(), startInline(), core(), onlyAscii()],
      worker: { format: "iife", plugins: () => [withoutAddress()] },
      build: {
        outDir: dist,
        emptyOutDir: false,
        target: "es2022",
        cssTarget: ["chrome105", "firefox110", "safari16"],
        modulePreload: false,
        chunkSizeWarningLimit: 5000,
        rolldownOptions: {
          input: inRoot("www", "src", "single.ts"),
          output: { format: "iife", entryFileNames: "mo-copp-playground.single.js", codeSplitting: false },
          // Only Vite's loader of chunks asks for it, and there are none.
          transform: { define: { "import.meta": "{}" } },
          checks: { pluginTimings: false },
        },
      },
    });
    return 0;
  } catch (error) {
    console.error(error);
    return 1;
  }
}

/** The client starts the worker that is in the script. */
function startInline() {
  return {
    name: "start-inline",
    enforce: "pre",
    resolveId(source, importer) {
      const fromClient = source === "./start.js" && /\/worker\/[^/]+\.ts$/.test(importer ?? "");
      return fromClient ? inRoot("www", "src", "worker", "inline.ts") : null;
    },
  };
}

function core() {
  const id = "virtual:core";
  return {
    name: "core",
    resolveId(source) {
      if (source === "virtual:lzma") return this.resolve("lzma1", inRoot("package.json"));
      return source === id ? `\0${id}` : null;
    },
    load(found) {
      if (found !== `\0${id}`) return null;
      const bytes = readFileSync(inRoot("www", "pkg", "mo_copp_bg.wasm"));
      return `export default ${JSON.stringify(Buffer.from(compress(new Uint8Array(bytes), 9)).toString("base64"))};`;
    },
  };
}
