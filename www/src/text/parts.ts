// A PDDL document as three texts: domain and problem in PDDL, and the rest as JSON. Nothing of a text is lost on the way
// there and back, right or wrong.
import { jsonLanguage } from "@codemirror/lang-json";
import { Text } from "@codemirror/state";
import type { Fault } from "../worker/protocol.js";
import { type Mark, markAt, wordAt } from "./fault.js";

export const partNames = ["domain", "problem", "rest"] as const;
export type PartName = (typeof partNames)[number];
export type Parts = Record<PartName, string>;

/** Null where the text is no PDDL document, or so broken that its parts cannot be told. */
export function split(text: string): Parts | null {
  // Most documents are told from PDDL without being read.
  if (!text.includes('"pddl"')) return null;
  const entries = entriesOf(text);
  const value = (name: string) => entries?.find(([key]) => key === name)?.[1];
  const domain = pddlOf(value("domain"));
  const problem = pddlOf(value("problem"));
  if (entries === null || value("format") !== '"pddl"' || domain === null || problem === null) return null;
  const inRest = entries.filter(([key]) => !["format", "domain", "problem"].includes(key));
  const lines = inRest.map(([key, source]) => `  ${JSON.stringify(key)}: ${source}`);
  return { domain, problem, rest: lines.length === 0 ? "{\n}\n" : `{\n${lines.join(",\n")}\n}\n` };
}

/** Keys and what is written behind them; null where that is no JSON object with each key once. */
function entriesOf(text: string): [key: string, source: string][] | null {
  try {
    JSON.parse(text);
  } catch {
    return null;
  }
  const object = jsonLanguage.parser.parse(text).topNode.firstChild;
  if (object?.name !== "Object") return null;
  const entries = object.getChildren("Property").map(({ firstChild, lastChild }): [string, string] => {
    const source = (node: typeof firstChild) => text.slice(node?.from, node?.to);
    return [JSON.parse(source(firstChild)), source(lastChild)];
  });
  return new Set(entries.map(([key]) => key)).size === entries.length ? entries : null;
}

function pddlOf(source: string | undefined): string | null {
  if (source === undefined) return null;
  const value: unknown = JSON.parse(source);
  if (typeof value === "string") return value;
  if (!Array.isArray(value) || value.length === 0) return null;
  return value.every((line) => typeof line === "string") ? value.join("\n") : null;
}

/** The document that three texts make. */
export function compose(parts: Parts): string {
  const head = headOf(parts);
  const rest = parts.rest.slice(head.skipped);
  return head.text + rest;
}

/** What is written before the rest, and how much of the rest's beginning it takes the place of. */
function headOf({ domain, problem, rest }: Parts): { text: string; skipped: number } {
  const skipped = /^\s*\{\s*/.exec(rest)?.[0].length ?? 0;
  const more = skipped > 0 && !rest.startsWith("}", skipped);
  const end = skipped > 0 && !more ? "\n" : `,${skipped > 0 ? "\n  " : "\n"}`;
  return {
    text: `{\n  "format": "pddl",\n  "domain": ${lines(domain)},\n  "problem": ${lines(problem)}${end}`,
    skipped,
  };
}

/** One text a line, as people read it. */
function lines(pddl: string): string {
  const all = pddl.split("\n");
  // A list of nothing is no text.
  return `[\n${all.map((line) => `    ${JSON.stringify(line)}`).join(",\n")}\n  ]`;
}

/** Which part a fault of the composed text is in, and where there. */
export function markIn(parts: Parts, docs: Record<PartName, Text>, fault: Fault): { part: PartName; mark: Mark } {
  const { message, path = "", place, line, column } = fault;
  const part = /^(domain|problem)\b/.exec(path)?.[1];
  if (part === "domain" || part === "problem") {
    return { part, mark: wordAt(docs[part], line ?? 1, column ?? 1, message) };
  }
  const composed = Text.of(compose(parts).split("\n"));
  const { text, skipped } = headOf(parts);
  const { from, to } = markAt(composed, place, message);
  // What is missing in the whole document is missing in the rest.
  const inRest = (at: number) => Math.min(Math.max(0, at - text.length + skipped), docs.rest.length);
  const begin = from < text.length ? 0 : inRest(from);
  return { part: "rest", mark: { message, from: begin, to: from < text.length ? begin : inRest(to) } };
}
