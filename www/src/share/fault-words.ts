// What is wrong with a document, in words that name a place which can be seen.
import { brief } from "../view/names.js";
import type { Fault } from "../worker/protocol.js";

/** With line and column of the whole document: the core counts those of a PDDL text inside of it from that text's start. */
export function inWhole({ message, path, line, column, place }: Fault): string {
  if (path === undefined || line === undefined || column === undefined) return message;
  const own = `${path}, line ${line}, column ${column}`;
  return message.startsWith(own)
    ? `${path}, line ${place.line}, column ${place.column}${message.slice(own.length)}`
    : message;
}

/** Of a file that is not on the page: its name, the place, and the text that stands there. */
export function inFile(name: string, text: string, fault: Fault): string {
  const words = inWhole(fault);
  const { line, column } = fault.place;
  const place = /\bline \d/.test(words) ? "" : ` line ${line}, column ${column},`;
  const there = text.split("\n")[line - 1]?.trim() ?? "";
  return `“${brief(name)}”,${place} ${words}${there === "" ? "" : ` — the line reads: ${brief(there)}`}`;
}
