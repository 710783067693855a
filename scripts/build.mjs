// `npm run build`: the wasm packages into www/pkg and www/pkg-light, then the page into dist/.
import { buildPage } from "./lib/build-page.mjs";
import { buildWasm } from "./lib/build-wasm.mjs";
import { setUp } from "./setup/all.mjs";

await setUp("page");
process.exitCode = (await buildWasm()) || (await buildPage());
if (process.exitCode === 0) console.log("Built: dist/");
