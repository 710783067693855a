// `npm run files`: the list of files in ARCHITECTURE.md, made from the first sentence of each file.
// With `--check` nothing is written: the exit code says whether the list is the one that would be.
import { readFileSync, writeFileSync } from "node:fs";
import { filesUnder } from "./lib/files-under.mjs";
import { fromRoot, inRoot } from "./lib/paths.mjs";

const folders = ["src", "www/src"];
const described = /\.(rs|ts)$/;
const page = inRoot("ARCHITECTURE.md");
const begin = "<!-- made by `npm run files` -->\n";
const end = "<!-- end of what is made -->\n";

/** The first sentence of the comment a file begins with; null where it begins with none. */
function firstSentence(text) {
  const comment = /^(\/\/[!]?(?: .*)?\n)+/.exec(text)?.[0] ?? "";
  const lines = comment.split("\n").map((line) => line.replace(/^\/\/!? ?/, ""));
  const blank = lines.indexOf("");
  // Links of rustdoc lead nowhere from here.
  const paragraph = lines
    .slice(0, blank)
    .join(" ")
    .replaceAll(/\[(`[^`]+`)\](\([^)]*\))?/g, "$1");
  return /^.+?[.?!](?=$| (?=[(\p{Lu}`“"']))/u.exec(paragraph)?.[0] ?? null;
}

function list() {
  const without = [];
  const lines = [];
  for (const file of folders.flatMap((folder) => filesUnder(inRoot(folder)))) {
    if (!described.test(file)) continue;
    const sentence = firstSentence(readFileSync(file, "utf8"));
    if (sentence === null) without.push(fromRoot(file));
    else lines.push(`- \`${fromRoot(file)}\`: ${sentence}\n`);
  }
  if (without.length > 0) {
    console.error(`These files do not begin with a comment that says what they are:\n  ${without.join("\n  ")}`);
    process.exit(1);
  }
  return lines.sort().join("");
}

const text = readFileSync(page, "utf8");
const [before, rest] = text.split(begin);
const after = rest?.split(end)[1];
if (after === undefined) throw new Error(`ARCHITECTURE.md has no ${begin.trim()} … ${end.trim()}`);
const made = `${before}${begin}${list()}${end}${after}`;
if (process.argv.includes("--check")) {
  if (made !== text) console.error("The list of files in ARCHITECTURE.md is not that of the files: npm run files");
  process.exitCode = made === text ? 0 : 1;
} else if (made !== text) {
  writeFileSync(page, made);
  console.log("The list of files in ARCHITECTURE.md is new.");
}
