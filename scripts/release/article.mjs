// The article in the npm package: beside the element, with its styles, and without links to pages of the site.
import { cpSync, readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { dist } from "../lib/paths.mjs";

/** Copies the built article into `folder`, whose neighbours are the folder `element` and the licences. */
export function copyArticle(folder) {
  cpSync(join(dist, "learn"), folder, { recursive: true });
  const beside = (file) => {
    cpSync(join(dist, file), join(folder, basename(file)));
    return `./${basename(file)}`;
  };
  const html = readFileSync(join(folder, "index.html"), "utf8")
    .replaceAll(/(?<=href=")\.\.\/((?:assets\/)?[\w.-]+\.(?:css|svg))(?=")/g, (_, file) => beside(file))
    .replaceAll('src="../assets/', 'src="../element/assets/')
    .replaceAll(/<link rel="modulepreload"[^>]*>\s*/g, "")
    .replaceAll(/(?<=href=")\.\.\/docs\/(LICENSE-\w+)\.txt(?=")/g, "../$1")
    .replaceAll(/<nav class="site"[\s\S]*?<\/nav>\s*/g, "")
    .replaceAll(/<a href="\.\.\/(?:docs\/)?[\w-]+\.html">([\s\S]*?)<\/a>/g, "$1");
  writeFileSync(join(folder, "index.html"), html);
}
