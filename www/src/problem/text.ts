// A document as text, written for people: one key a line, cells and short objects on one, PDDL line by line.
import type { ProblemDocument } from "./types.js";

const LINE = 110;

export function written(document: ProblemDocument): string {
  return `${block(document, 0)}\n`;
}

/** On one line when it fits, else one entry a line. */
function block(value: unknown, depth: number): string {
  const flat = line(value);
  const fits = flat.length + 2 * depth <= LINE && depth > 0;
  if (fits || typeof value !== "object" || value === null) return flat;
  const indent = "  ".repeat(depth + 1);
  const end = `\n${"  ".repeat(depth)}`;
  if (Array.isArray(value)) return rows(value, depth, indent, end);
  const entries = Object.entries(value).filter(([, entry]) => entry !== undefined);
  const written = ([key, entry]: [string, unknown]) =>
    depth === 0 && isPddl(key, entry) ? lineByLine(entry) : block(entry, depth + 1);
  return `{\n${entries.map((entry) => `${indent}${JSON.stringify(entry[0])}: ${written(entry)}`).join(",\n")}${end}}`;
}

/** A list of the lines of a text. */
const isPddl = (key: string, value: unknown): value is string[] =>
  (key === "domain" || key === "problem") && Array.isArray(value) && value.every((line) => typeof line === "string");

const lineByLine = (lines: string[]): string =>
  `[\n${lines.map((text) => `    ${JSON.stringify(text)}`).join(",\n")}\n  ]`;

/** Short entries fill lines; long ones get one each. */
function rows(list: unknown[], depth: number, indent: string, end: string): string {
  const lines: string[] = [];
  // PDDL is a list of lines, and stays one.
  const isText = list.some((entry) => typeof entry === "string" && entry.includes("("));
  for (const entry of list) {
    const text = block(entry, depth + 1);
    const last = lines.at(-1);
    const short = !isText && (Array.isArray(entry) || typeof entry !== "object");
    if (short && last !== undefined && last.length + text.length + 2 + indent.length <= LINE) {
      lines[lines.length - 1] = `${last}, ${text}`;
    } else {
      lines.push(text);
    }
  }
  return `[\n${lines.map((text) => indent + text).join(",\n")}${end}]`;
}

function line(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(line).join(", ")}]`;
  if (typeof value !== "object" || value === null) return JSON.stringify(value);
  const entries = Object.entries(value).filter(([, entry]) => entry !== undefined);
  return `{${entries.map(([key, entry]) => `${JSON.stringify(key)}: ${line(entry)}`).join(", ")}}`;
}
