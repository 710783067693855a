// The files of a release, in one folder, from the built page and the built package (docs/release.md).
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { dist, inRoot } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";
import { pack } from "./package.mjs";

/** Writes all of them; resolves to the exit code. `target` is the folder that cargo packs in. */
export async function releaseFiles(folder, target = inRoot("target")) {
  const { version } = JSON.parse(readFileSync(inRoot("package.json"), "utf8"));
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const code =
    (await pack(folder)) ||
    (await run("tar", ["-czf", join(folder, `mo-copp-page-${version}.tar.gz`), "-C", inRoot(), basename(dist)])) ||
    (await crate(folder, target, `mo-copp-${version}.crate`));
  if (code !== 0) return code;
  cpSync(join(dist, "mo-copp-playground.single.js"), join(folder, `mo-copp-playground.single-${version}.js`));
  sums(folder);
  return 0;
}

/** The crate as it would be published; no crate is fetched for it. The working tree may hold what is not committed yet. */
async function crate(folder, target, file) {
  const args = ["package", "--no-verify", "--allow-dirty", "--locked", "--offline", "--quiet"];
  const code = await run("cargo", [...args, "--target-dir", target]);
  if (code === 0) cpSync(join(target, "package", file), join(folder, file));
  return code;
}

/** Checksums of each file, and what pages write into `integrity` for the scripts. */
function sums(folder) {
  const hash = (kind, path, as) => createHash(kind).update(readFileSync(path)).digest(as);
  const lines = readdirSync(folder)
    .sort()
    .map((file) => `${hash("sha256", join(folder, file), "hex")}  ${file}\n`);
  writeFileSync(join(folder, "SHA256SUMS"), lines.join(""));
  const scripts = ["mo-copp-playground.js", "mo-copp-playground.single.js"];
  const integrity = scripts.map((file) => [file, `sha384-${hash("sha384", join(dist, file), "base64")}`]);
  writeFileSync(join(folder, "integrity.json"), `${JSON.stringify(Object.fromEntries(integrity), null, 2)}\n`);
}
