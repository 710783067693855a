// `node kits/scorm/build.mjs OUT.zip`: the SCORM package, from this folder and the built page.
import { cpSync, mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { dist } from "../../scripts/lib/paths.mjs";
import { run } from "../../scripts/lib/run.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const out = resolve(process.argv[2] ?? "mo-copp-scorm.zip");
const folder = mkdtempSync(join(tmpdir(), "mo-copp-scorm-"));
try {
  for (const file of ["imsmanifest.xml", "playground.html", "scorm.js"]) cpSync(join(here, file), join(folder, file));
  cpSync(join(dist, "mo-copp-playground.single.js"), join(folder, "mo-copp-playground.single.js"));
  const files = readdirSync(folder).map((file) => join(folder, file));
  process.exitCode = await run("python3", ["-m", "zipfile", "-c", out, ...files]);
} finally {
  rmSync(folder, { recursive: true });
}
