// The exercises of the lesson, as the site and the package have them.
import { readdirSync, readFileSync } from "node:fs";
import { inRoot } from "../lib/paths.mjs";

const folder = inRoot("examples", "exercises");

/** Name and content of each file.
 * @type {() => (readonly [name: string, text: string])[]} */
export const exerciseFiles = () =>
  readdirSync(folder)
    .filter((name) => name.endsWith(".json"))
    .sort()
    .map((name) => [name, readFileSync(`${folder}/${name}`, "utf8")]);
