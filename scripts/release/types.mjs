// The types of the element that its source declares, as the package has them: each is written once, in the source.
import { readFileSync } from "node:fs";
import { inRoot } from "../lib/paths.mjs";

/** Where each stands. What they need of others is among them, or the core's. */
const sources = {
  "worker/protocol.ts": ["Answered"],
  "element/solve-options.ts": ["ElementSolveOptions"],
  "element/svg-options.ts": ["SvgOptions", "PngOptions"],
  "element/events.ts": ["StepDetail", "AnswerDetail", "ScoreDetail"],
};

/** What these are made of. */
const ofCore = ["ByObserver", "Outcome", "PictureOptions", "SolveOptions"];

/** The text of `types.d.ts`. */
export function elementTypes() {
  const declared = Object.entries(sources).flatMap(([file, names]) => {
    const text = readFileSync(inRoot("www", "src", file), "utf8");
    return names.map((name) => declaration(text, name, file));
  });
  const needed = `import type { ${ofCore.join(", ")} } from "../core/mo_copp.js";`;
  return `${[needed, ...declared].join("\n\n")}\n`;
}

/** An exported type with the comment before it, as the project's format writes it. */
function declaration(text, name, file) {
  const comment = String.raw`(?:^\/\*\*(?:[^*]|\*(?!\/))*\*\/\n)?`;
  const body = String.raw`(?:interface ${name}\b[^]*?^\}|type ${name} =[^]*?;$)`;
  const [found] = new RegExp(`${comment}^export ${body}`, "m").exec(text) ?? [];
  if (found === undefined) throw new Error(`${file} declares no exported type ${name}`);
  return found;
}
