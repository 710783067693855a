// custom-elements.json: what the analyzer reads from the element's class, with the addresses of the package.
import { readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { root } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";

const NAME = "mo-copp-playground";

/** Resolves to the manifest, or null where the analyzer failed. `folder`, below the root, is where it writes. */
export async function elementManifest(folder) {
  const globs = ["mo-copp-playground.ts", "playground-element.ts"].flatMap((file) => [
    "--globs",
    `www/src/element/${file}`,
  ]);
  if ((await run("cem", ["analyze", ...globs, "--outdir", relative(root, folder), "--quiet"])) !== 0) return null;
  return ofPackage(JSON.parse(readFileSync(join(folder, "custom-elements.json"), "utf8")));
}

/** One module with one element; what is private stays out. */
function ofPackage({ schemaVersion, modules }) {
  const declaration = modules.flatMap(({ declarations }) => declarations).find(({ tagName }) => tagName === NAME);
  const seen = (members = []) => members.filter(({ privacy, static: fixed }) => privacy === undefined && !fixed);
  const path = "element/index.js";
  const { superclass, ...element } = declaration;
  // A computed name, in brackets, is the project's own.
  const members = seen(declaration.members).filter(({ name }) => !/^\[|Callback$/.test(name));
  return {
    schemaVersion,
    readme: "README.md",
    modules: [
      {
        kind: "javascript-module",
        path,
        declarations: [
          {
            ...element,
            superclass: { name: "HTMLElement" },
            attributes: element.attributes.map((attribute) => ({
              ...attribute,
              fieldName: propertyOf(attribute.name),
            })),
            members: [...members.map(({ inheritedFrom, ...rest }) => rest), ...element.attributes.map(reflecting)],
          },
        ],
        exports: [
          { kind: "js", name: element.name, declaration: { name: element.name, module: path } },
          { kind: "custom-element-definition", name: NAME, declaration: { name: element.name, module: path } },
        ],
      },
    ],
  };
}

/** `worker-url` is `workerUrl`. */
const propertyOf = (attribute) => attribute.replace(/-(.)/g, (_, letter) => letter.toUpperCase());

/** Each attribute is a property as well, which the element makes of their list. */
const reflecting = ({ name, type, description }) => ({
  kind: "field",
  name: propertyOf(name),
  type: { text: type?.text === "boolean" ? "boolean" : "string | null" },
  description,
  attribute: name,
  reflects: true,
});
