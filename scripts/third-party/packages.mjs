// The npm packages of which something is in the built page: Vite's bundler says which modules each file was made of.
import { existsSync, readFileSync } from "node:fs";
import { dirname, join, sep } from "node:path";
import { noticesIn } from "./notices.mjs";

const packages = `${sep}node_modules${sep}`;

/** The folder of the package that a module belongs to; null for modules of the project. */
function folderOf(module) {
  const file = module.replace(/^\0/, "").replace(/\?.*$/, "");
  if (!file.includes(packages)) return null;
  for (let folder = dirname(file); folder.includes(packages.slice(0, -1)); folder = dirname(folder)) {
    const manifest = join(folder, "package.json");
    // A package may hold manifests of parts, which say no more than how to load them.
    if (existsSync(manifest) && JSON.parse(readFileSync(manifest, "utf8")).version !== undefined) return folder;
  }
  return null;
}

/** Entries of the packages of these modules, in the order of their names. */
export function npmPackages(modules) {
  const folders = new Set([...modules].map(folderOf).filter((folder) => folder !== null));
  return [...folders].map(entry).sort((one, other) => (one.name < other.name ? -1 : 1));
}

function entry(folder) {
  const { name, version, license, author, repository } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  return {
    name,
    version,
    licence: license,
    from: typeof repository === "string" ? repository : repository?.url,
    authors: [typeof author === "string" ? author : author?.name].filter(Boolean),
    notices: noticesIn(folder),
  };
}
