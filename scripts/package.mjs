// `npm run package`: the npm package, in dist-package/, from the built page (`npm run build`).
import { buildPackage } from "./release/package.mjs";

process.exitCode = await buildPackage();
if (process.exitCode === 0) console.log("Built: dist-package/");
