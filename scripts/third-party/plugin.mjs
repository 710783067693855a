// What the page is made of that others wrote: `THIRD-PARTY.txt` in the built site, which its footer leads to.
import { inRoot } from "../lib/paths.mjs";
import { crates } from "./crates.mjs";
import { npmPackages } from "./packages.mjs";

const rule = "=".repeat(78);

/** The packages, each with the numbers of its texts, then the texts: many packages come with the same one. */
export function written(entries) {
  const texts = [...new Set(entries.flatMap(({ notices }) => notices))];
  const lines = entries.map(({ name, version, licence, from, authors, notices }) =>
    [
      `${name} ${version}`,
      `  licence: ${licence}`,
      ...(authors.length > 0 ? [`  authors: ${authors.join(", ")}`] : []),
      ...(from ? [`  from: ${from}`] : []),
      `  texts: ${notices.map((text) => texts.indexOf(text) + 1).join(", ") || "the package comes with none"}`,
    ].join("\n"),
  );
  const numbered = texts.map((text, index) => `${rule}\nText ${index + 1}\n${rule}\n\n${text}\n`);
  const begin = "The mo-copp playground is made with these packages, each under its own licence. The texts follow.";
  return `${[begin, ...lines, ...numbered].join("\n\n")}`;
}

/** What the element as one file holds beside what the page does; it is built by itself. */
const inOneFile = [inRoot("node_modules", "lzma1", "lib", "index.js")];

/** Two plugins of Vite: one for the page, one for its workers, which are bundled by themselves. */
export function thirdParty() {
  const modules = new Set();
  const collect = (_options, bundle) => {
    for (const file of Object.values(bundle)) {
      for (const module of file.type === "chunk" ? file.moduleIds : []) modules.add(module);
    }
  };
  return {
    worker: { name: "third-party-in-workers", generateBundle: collect },
    page: {
      name: "third-party",
      apply: "build",
      generateBundle(options, bundle) {
        collect(options, bundle);
        const source = written([...npmPackages([...modules, ...inOneFile]), ...crates()]);
        this.emitFile({ type: "asset", fileName: "THIRD-PARTY.txt", source });
      },
    },
  };
}
