// `npm run release`: everything that a release is made of, in release/ (docs/release.md).
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { buildPage } from "./lib/build-page.mjs";
import { buildWasm } from "./lib/build-wasm.mjs";
import { dist, inRoot } from "./lib/paths.mjs";
import { run } from "./lib/run.mjs";
import { buildPackage, pack } from "./release/package.mjs";
import { setUp } from "./setup/all.mjs";

const folder = inRoot("release");
const { version } = JSON.parse(readFileSync(inRoot("package.json"), "utf8"));

await setUp("page");
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder);
process.exitCode =
  (await buildWasm()) ||
  (await buildPage()) ||
  (await buildPackage()) ||
  (await pack(folder)) ||
  (await run("tar", ["-czf", join(folder, `mo-copp-page-${version}.tar.gz`), "-C", inRoot(), basename(dist)])) ||
  (await crate());
if (process.exitCode === 0) {
  cpSync(join(dist, "mo-copp-playground.single.js"), join(folder, `mo-copp-playground.single-${version}.js`));
  sums();
  console.log("Made: release/");
}

/** The crate as it would be published. The working tree may hold what is not committed yet. */
async function crate() {
  const code = await run("cargo", ["package", "--no-verify", "--allow-dirty", "--locked"]);
  if (code === 0)
    cpSync(inRoot("target", "package", `mo-copp-${version}.crate`), join(folder, `mo-copp-${version}.crate`));
  return code;
}

/** Checksums of each file, and what pages write into `integrity` for the scripts. */
function sums() {
  const files = readdirSync(folder).sort();
  const bytes = (path) => readFileSync(path);
  const sum = (file) =>
    createHash("sha256")
      .update(bytes(join(folder, file)))
      .digest("hex");
  writeFileSync(join(folder, "SHA256SUMS"), files.map((file) => `${sum(file)}  ${file}\n`).join(""));
  const scripts = ["mo-copp-playground.js", "mo-copp-playground.single.js"];
  const hash = (file) =>
    `sha384-${createHash("sha384")
      .update(bytes(join(dist, file)))
      .digest("base64")}`;
  const integrity = Object.fromEntries(scripts.map((file) => [file, hash(file)]));
  writeFileSync(join(folder, "integrity.json"), `${JSON.stringify(integrity, null, 2)}\n`);
}
