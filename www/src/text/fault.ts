// What is wrong with the text in a field, and the places that the core names, as the field counts them.
import type { Text } from "@codemirror/state";
import type { Place } from "../core.js";

/** A message and what it is about: nothing, where something is missing. */
export interface Mark {
  message: string;
  from: number;
  to: number;
}

/** The core counts lines from 1 and characters from 1; the field counts from 0, characters beyond U+FFFF twice. */
export function offset(text: Text, line: number, column: number): number {
  const { from, text: content } = text.line(Math.min(Math.max(line, 1), text.lines));
  return from + units(content, column - 1);
}

export function markAt(text: Text, { line, column, length }: Place, message: string): Mark {
  return { message, from: offset(text, line, column), to: offset(text, line, column + length) };
}

/** A word from a place on, as far as brackets and space let it go. */
export function wordAt(text: Text, line: number, column: number, message: string): Mark {
  const from = offset(text, line, column);
  const rest = text.sliceString(from, Math.min(text.lineAt(from).to, from + 200));
  return { message, from, to: from + (/^[^\s()]+|^\S/.exec(rest)?.[0].length ?? 0) };
}

function units(content: string, characters: number): number {
  let at = 0;
  for (let count = 0; count < characters && at < content.length; count += 1) {
    at += (content.codePointAt(at) ?? 0) > 0xffff ? 2 : 1;
  }
  return at;
}
