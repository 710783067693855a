// `npm run release`: everything that a release is made of, in release/ (docs/release.md).
import { buildPage } from "./lib/build-page.mjs";
import { buildWasm } from "./lib/build-wasm.mjs";
import { inRoot } from "./lib/paths.mjs";
import { releaseFiles } from "./release/files.mjs";
import { buildPackage } from "./release/package.mjs";
import { setUp } from "./setup/all.mjs";

await setUp("page");
process.exitCode =
  (await buildWasm()) || (await buildPage()) || (await buildPackage()) || (await releaseFiles(inRoot("release")));
if (process.exitCode === 0) console.log("Made: release/");
