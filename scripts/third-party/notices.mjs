// The licence and notice files of a package's folder.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const NAMES = /^(licen[cs]e|copying|copyright|notice|unlicense)/i;

/** The texts of the files of a folder that have such a name, each once; none where there is no such folder. */
export function noticesIn(folder, names = NAMES) {
  if (!existsSync(folder)) return [];
  const files = readdirSync(folder, { withFileTypes: true })
    .filter((file) => file.isFile() && names.test(file.name))
    .map((file) => file.name)
    .sort();
  const texts = files.map((file) => readFileSync(join(folder, file), "utf8").replaceAll("\r\n", "\n").trim());
  return [...new Set(texts)];
}
