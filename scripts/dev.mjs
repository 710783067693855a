// `npm run dev`: the page by Vite's own server, which reloads it when a file under www/ changes.
import { buildWasm } from "./lib/build-wasm.mjs";
import { run } from "./lib/run.mjs";
import { setUp } from "./setup/all.mjs";

await setUp("page");
process.exitCode = (await buildWasm()) || (await run("vite", []));
