// All files below a folder, in a fixed order.
import { readdirSync } from "node:fs";
import { join } from "node:path";

export const filesUnder = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
    .sort();
