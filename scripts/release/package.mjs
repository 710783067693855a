// The npm package: the element, the solver, the one script, the article, the exercises, types, the manifest of the element, and licences.
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { exerciseFiles } from "../exercises/files.mjs";
import { dist, inRoot, wasmPackage } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";
import { copyArticle } from "./article.mjs";
import { elementManifest } from "./manifest.mjs";
import { elementTypes } from "./types.mjs";

export const packageFolder = inRoot("dist-package");
const to = (...parts) => join(packageFolder, ...parts);

/** Styles and scripts of the stand-alone page alone. */
const ofThePage = /\.css$|^index-/;

/** Resolves to the exit code. */
export async function buildPackage() {
  if (!existsSync(join(dist, "mo-copp-playground.single.js"))) {
    console.error("The page is not built. What helps: npm run build");
    return 1;
  }
  rmSync(packageFolder, { recursive: true, force: true });
  cpSync(inRoot("package"), packageFolder, { recursive: true });
  copyScripts();
  writeFileSync(to("element", "types.d.ts"), elementTypes());
  copyArticle(to("learn"));
  mkdirSync(to("exercises"));
  for (const [name, text] of exerciseFiles()) writeFileSync(to("exercises", name), text);
  const { version } = JSON.parse(readFileSync(inRoot("package.json"), "utf8"));
  const described = JSON.parse(readFileSync(to("package.json"), "utf8"));
  writeFileSync(to("package.json"), `${JSON.stringify({ ...described, version }, null, 2)}\n`);
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) cpSync(inRoot(name), to(name));
  // The page's build knows what it bundled.
  cpSync(join(dist, "THIRD-PARTY.txt"), to("THIRD-PARTY.txt"));
  const manifest = await elementManifest(packageFolder);
  if (manifest === null) return 1;
  writeFileSync(to("custom-elements.json"), `${JSON.stringify(manifest, null, 2)}\n`);
  return 0;
}

/** The list of files that a chunk loads ahead, as Vite writes it: a bundler gives them other names. */
const loadedAhead = /^(const __vite__mapDeps=.*?)=>i\.map\(i=>d\[i\]\)/;

/** Copies a script of the element; it loads nothing ahead. */
function copyScript(...file) {
  const script = readFileSync(join(dist, ...file), "utf8");
  writeFileSync(to("element", ...file), script.replace(loadedAhead, "$1=>[]"));
}

function copyScripts() {
  mkdirSync(to("element", "assets"), { recursive: true });
  copyScript("mo-copp-playground.js");
  for (const file of readdirSync(join(dist, "assets")).filter((name) => !ofThePage.test(name))) {
    if (file.endsWith(".js")) copyScript("assets", file);
    else cpSync(join(dist, "assets", file), to("element", "assets", file));
  }
  cpSync(join(dist, "mo-copp-playground.single.js"), to("single", "index.js"));
  for (const file of ["mo_copp.js", "mo_copp_bg.wasm"]) cpSync(join(wasmPackage, file), to("core", file));
  writeFileSync(to("core", "mo_copp.d.ts"), coreTypes(readFileSync(join(wasmPackage, "mo_copp.d.ts"), "utf8")));
}

/** The types of the bindings, without what only the newest libraries of TypeScript know (what a `using` calls), or those
 * of a browser alone: how the bindings are loaded, which `load` does. */
function coreTypes(text) {
  const loading = text.indexOf("\nexport type InitInput");
  if (loading === -1)
    throw new Error("mo_copp.d.ts has no InitInput; expected that how the core is loaded begins there");
  return text.slice(0, loading).replace(/^ *\[Symbol\.dispose\]\(\): void;\n/gm, "");
}

/** Packs the package into `folder`; resolves to the exit code. */
export const pack = (folder) => run("npm", ["pack", "--silent", packageFolder, "--pack-destination", folder]);
