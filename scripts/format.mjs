// `npm run format`: writes every file in the project's format.
import { run } from "./lib/run.mjs";
import { setUp } from "./setup/all.mjs";

await setUp("lint");
process.exitCode = (await run("cargo", ["fmt"])) || (await run("biome", ["check", "--write"]));
